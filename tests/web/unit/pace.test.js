import assert from "node:assert/strict";
import { test } from "node:test";
import { Pace } from "amalgam-page/pace.js";

// A server that takes `server` ms for a frame, one after the other, behind a way of `way` ms.
// Returns the mean limit over the frames.
function run(pace, { server, way }, frames) {
  let now = 0;
  let sum = 0;
  for (let i = 0; i < frames; ++i) {
    const alone = server + way;
    // With two under way the second waits until the server is free.
    const interval = pace.limit === 1 ? alone : Math.max(server, alone / 2);
    const delay = pace.limit === 1 ? alone : Math.max(alone, 2 * server);
    now += interval;
    sum += pace.limit;
    pace.shown(delay, now);
  }
  return sum / frames;
}

test("a long way takes two frames at once", () => {
  const pace = new Pace();
  run(pace, { server: 20, way: 80 }, 100);
  assert.equal(pace.limit, 2);
  assert.ok(run(pace, { server: 20, way: 80 }, 2000) > 1.8);
});

test("a slow server gets one frame at a time: the second would only wait", () => {
  const pace = new Pace();
  run(pace, { server: 100, way: 10 }, 100);
  assert.equal(pace.limit, 1);
  assert.ok(run(pace, { server: 100, way: 10 }, 2000) < 1.1);
});

test("two at once are not kept where they bring nothing, as with a slow camera", () => {
  const pace = new Pace();
  for (let i = 0; i < 100; ++i) pace.shown(50, 200 * i);
  assert.equal(pace.limit, 1);
});

test("a server that becomes slow is noticed", () => {
  const pace = new Pace();
  run(pace, { server: 20, way: 80 }, 100);
  assert.equal(pace.limit, 2);
  run(pace, { server: 100, way: 10 }, 400);
  assert.equal(pace.limit, 1);
});
