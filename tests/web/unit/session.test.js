// The conversation, with a clock and a network of the test's own.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { Session } from "amalgam-page/session.js";
import { decode, encode } from "amalgam-page/wire.js";

class FakeSocket {
  static OPEN = 1;
  static all = [];
  readyState = 0;
  sent = [];
  closed = false;

  constructor(address) {
    this.address = address;
    FakeSocket.all.push(this);
  }
  accept() {
    this.readyState = FakeSocket.OPEN;
    this.onopen({});
  }
  say(kind, value) {
    this.onmessage({ data: encode(kind, value).slice().buffer });
  }
  end() {
    this.readyState = 3;
    this.onclose({ reason: "" });
  }
  send(bytes) {
    this.sent.push(decode(bytes));
  }
  close() {
    this.closed = true;
  }
}

class FakeClock {
  time = 0;
  #timers = new Map();
  #next = 1;

  setTimeout = (f, ms) => {
    this.#timers.set(this.#next, { f, at: this.time + ms });
    return this.#next++;
  };
  clearTimeout = (timer) => this.#timers.delete(timer);
  now = () => this.time;

  pass(ms) {
    const end = this.time + ms;
    for (;;) {
      const due = [...this.#timers].filter(([, { at }]) => at <= end);
      if (due.length === 0) break;
      const [timer, { f, at }] = due.reduce((a, b) => (a[1].at <= b[1].at ? a : b));
      this.#timers.delete(timer);
      this.time = at;
      f();
    }
    this.time = end;
  }
}

const WELCOME = {
  limits: { idleTimeoutMs: 5000 },
  markers: { dictionary: "DICT_6X6_250", ids: [40] },
};

let clock;
let told;
let session;
const socket = () => FakeSocket.all.at(-1);
const kinds = () => told.map(({ kind }) => kind);

beforeEach(() => {
  FakeSocket.all = [];
  clock = new FakeClock();
  told = [];
  const listener = {
    status: (status) => told.push(status),
    composite: ({ frameId }) => told.push({ kind: "composite", frameId }),
    error: ({ code, frameId }) => told.push({ kind: "error", code, frameId }),
  };
  const tools = { WebSocket: FakeSocket, random: () => 1, ...clock };
  session = new Session("ws://a/session", { token: "secret" }, listener, tools);
  session.open();
});

const welcome = () => {
  socket().accept();
  socket().say("welcome", WELCOME);
};

test("says hello first, and is ready after the welcome", () => {
  assert.equal(session.sendFrame({}), false);
  welcome();
  assert.equal(socket().sent[0].case, "hello");
  assert.equal(socket().sent[0].value.token, "secret");
  assert.equal(socket().sent[0].value.version, 1);
  assert.deepEqual(kinds(), ["connecting", "ready"]);
  assert.ok(session.sendFrame({ frameId: 1n }));
});

test("answers pings by their nonce", () => {
  welcome();
  socket().say("ping", { nonce: 12n });
  assert.equal(socket().sent.at(-1).case, "pong");
  assert.equal(socket().sent.at(-1).value.nonce, 12n);
});

test("a full server is left alone for as long as it asks, and then tried again", () => {
  socket().accept();
  socket().say("busy", { retryAfterMs: 2000, reason: "too many connections" });
  assert.equal(told.at(-1).kind, "busy");
  assert.equal(told.at(-1).retryAt, 2500); // the longest: random() is 1
  socket().end(); // the server closes behind it, which is no loss
  clock.pass(2400);
  assert.equal(FakeSocket.all.length, 1);
  clock.pass(200);
  assert.equal(FakeSocket.all.length, 2);
});

test("a lost connection comes back later each time, and at once after a success", () => {
  const waits = [];
  for (let i = 0; i < 7; ++i) {
    socket().end();
    assert.equal(told.at(-1).kind, "lost");
    waits.push(told.at(-1).retryAt - clock.time);
    clock.pass(waits.at(-1));
  }
  assert.deepEqual(waits, [500, 1000, 2000, 4000, 8000, 15000, 15000]);
  welcome();
  socket().end();
  assert.equal(told.at(-1).retryAt - clock.time, 500);
});

test("silence is a loss", () => {
  welcome();
  clock.pass(4900);
  socket().say("ping", { nonce: 1n });
  clock.pass(4900);
  assert.equal(told.at(-1).kind, "ready");
  clock.pass(200);
  assert.equal(told.at(-1).kind, "lost");
  assert.ok(FakeSocket.all[0].closed);
});

test("a wrong token is not tried again", () => {
  socket().accept();
  socket().say("error", { code: 5, text: "wrong token", closes: true });
  assert.deepEqual(
    [told.at(-1).kind, told.at(-1).code, told.at(-1).text],
    ["refused", "AUTH_FAILED", "wrong token"],
  );
  socket().end();
  clock.pass(60000);
  assert.equal(FakeSocket.all.length, 1);
});

test("an error of one frame leaves the session as it is", () => {
  welcome();
  socket().say("error", { code: 12, text: "no JPEG", frameId: 3n });
  assert.deepEqual(told.at(-1), { kind: "error", code: "BAD_IMAGE", frameId: 3n });
  assert.ok(session.sendFrame({ frameId: 4n }));
});

test("a server that drains gets no more frames, and is tried again after its end", () => {
  welcome();
  socket().say("draining", { deadlineMs: 20000 });
  assert.equal(session.sendFrame({ frameId: 1n }), false);
  socket().say("composite", { frameId: 0n });
  assert.equal(told.at(-1).kind, "composite");
  socket().end();
  assert.match(told.at(-1).reason, /has ended/);
  clock.pass(600);
  assert.equal(FakeSocket.all.length, 2);
});

test("what is no message is a loss, not an exception", () => {
  welcome();
  socket().onmessage({ data: new Uint8Array([0x42, 0xff]).buffer });
  assert.equal(told.at(-1).kind, "lost");
});

test("closing says goodbye and stays closed", () => {
  welcome();
  session.close();
  assert.equal(FakeSocket.all[0].sent.at(-1).case, "goodbye");
  clock.pass(60000);
  assert.equal(FakeSocket.all.length, 1);
  assert.equal(told.at(-1).kind, "closed");
});

test("a socket that was given up is not listened to", () => {
  const old = socket();
  session.open();
  old.readyState = FakeSocket.OPEN;
  old.onopen({});
  assert.deepEqual(old.sent, []);
});
