// A frame's way through the page, with a worker and a session that the test plays.
import assert from "node:assert/strict";
import { afterEach, beforeEach, mock, test } from "node:test";
import { FrameLoop } from "amalgam-page/frame_loop.js";

let clock;
let worker;
let sent;
let told;
let loop;
let finishShowing;

beforeEach(() => {
  clock = 1000;
  mock.method(performance, "now", () => clock);
  globalThis.createImageBitmap = async () => ({});
  worker = { frames: [], postMessage: ({ frameId }) => worker.frames.push(frameId) };
  sent = [];
  told = { skipped: 0, lost: 0 };
  const session = { sendFrame: (frame) => sent.push(frame) > 0 };
  loop = new FrameLoop(worker, session, {
    skipped: () => ++told.skipped,
    lost: () => ++told.lost,
    found: () => {},
    answered: () => new Promise((resolve) => (finishShowing = resolve)),
  });
});
afterEach(() => {
  mock.restoreAll();
  delete globalThis.createImageBitmap;
});

const picture = () => ({
  isClosed: false,
  close() {
    this.isClosed = true;
  },
});

/** The worker is done with the newest frame. @returns {object} its picture */
function encoded() {
  const result = picture();
  const frameId = worker.frames.at(-1);
  const times = { read: 1, search: 1, encode: 1 };
  const data = { kind: "frame", frameId, jpeg: new ArrayBuffer(1), corners: [], times };
  worker.onmessage({ data: { ...data, picture: result } });
  return result;
}

test("one frame at a time, until it has been shown", async () => {
  await loop.capture({}, clock);
  const shown = encoded();
  await loop.capture({}, clock);
  assert.deepEqual([worker.frames, told.skipped], [[1n], 1]);
  const showing = loop.composite({ frameId: 1n });
  await loop.capture({}, clock);
  assert.equal(told.skipped, 2);
  finishShowing();
  await showing;
  await loop.capture({}, clock);
  assert.deepEqual(worker.frames, [1n, 2n]);
  assert.ok(!shown.isClosed); // it is the view's
});

test("a frame without an answer makes room", async () => {
  await loop.capture({}, clock);
  const unanswered = encoded();
  clock += 4001;
  await loop.capture({}, clock);
  assert.deepEqual([worker.frames, told.lost], [[1n, 2n], 1]);
  assert.ok(unanswered.isClosed);
  await loop.composite({ frameId: 1n }); // too late: nothing happens
});

test("a late answer that is being shown keeps its picture", async () => {
  await loop.capture({}, clock);
  const late = encoded();
  clock += 3999;
  const showing = loop.composite({ frameId: 1n });
  clock += 10;
  await loop.capture({}, clock);
  loop.stop();
  assert.equal(told.lost, 0);
  assert.ok(!late.isClosed);
  finishShowing();
  await showing;
});

test("what the session cannot send is given up", async () => {
  const refusing = new FrameLoop(worker, { sendFrame: () => false }, { found: () => {} });
  await refusing.capture({}, clock);
  assert.ok(encoded().isClosed);
  await refusing.capture({}, clock);
  assert.deepEqual(worker.frames, [1n, 2n]);
});
