// The protocol's text is normative: its examples are what the page must read and write.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { decode, encode, errorName } from "amalgam-page/wire.js";
import { sourceFile } from "../support/places.js";

const LENGTH_BYTES = 4; // before each message over TCP, but not over a WebSocket

/** @returns {Map<string, Uint8Array[]>} the hex examples by the message's name */
function examples() {
  const text = readFileSync(sourceFile("protocol/PROTOCOL.md"), "utf8");
  const found = new Map();
  for (const [, name, hex] of text.matchAll(/```hex (\w+)\n([^`]*)```/g)) {
    const bytes = Uint8Array.from(hex.trim().split(/\s+/), (digits) => parseInt(digits, 16));
    found.set(name, [...(found.get(name) ?? []), bytes.subarray(LENGTH_BYTES)]);
  }
  return found;
}

const kind = (name) => name.charAt(0).toLowerCase() + name.slice(1);

test("all messages of the protocol's text are read", () => {
  const all = examples();
  assert.ok(all.size >= 11, `${all.size} messages`);
  for (const [name, list] of all) {
    for (const bytes of list) assert.equal(decode(bytes).case, kind(name));
  }
});

test("what is written is what the protocol's text shows", () => {
  for (const name of ["Hello", "CameraFrame", "Pong", "Goodbye"]) {
    const [bytes] = examples().get(name);
    assert.deepEqual(encode(kind(name), decode(bytes).value), bytes, name);
  }
});

test("values arrive under the names that the page uses", () => {
  const { value } = decode(examples().get("Welcome")[0]);
  assert.equal(value.markers.dictionary, "DICT_6X6_250");
  assert.deepEqual(value.markers.ids, [40, 23]);
  assert.equal(value.limits.idleTimeoutMs, 5000);
  const busy = decode(examples().get("Busy")[0]).value;
  assert.equal(busy.retryAfterMs, 2000);
});

test("frames carry corners", () => {
  const pixels = [1.5, 2, 3, 4, 5, 6, 7, 8.25];
  const corners = [{ marker: 40, pixels }];
  const frame = { frameId: 7n, captureTimeUs: 9n, jpeg: new Uint8Array([255, 216]), corners };
  const { value } = decode(encode("cameraFrame", frame));
  assert.equal(value.frameId, 7n);
  assert.deepEqual(value.corners[0].pixels, pixels);
});

test("what is no message is refused", () => {
  assert.throws(() => decode(new Uint8Array(0)), /without a body/);
  assert.throws(() => decode(new Uint8Array([0x42, 0xff])));
  assert.throws(() => decode(new Uint8Array(33 * 1024 * 1024)), /too long/);
});

test("error codes have the protocol's names", () => {
  assert.equal(errorName(5), "AUTH_FAILED");
  assert.equal(errorName(99), "ERROR_99");
});
