// What the status page makes of the server's figures.
import assert from "node:assert/strict";
import { test } from "node:test";
import { CHARTS, stacked } from "amalgam-status/chart_data.js";
import { History, SPAN_S } from "amalgam-status/history.js";
import { Metrics } from "amalgam-status/metrics_text.js";
import { quantile } from "amalgam-status/quantile.js";
import { bytes, duration, number, readiness, skips } from "amalgam-status/words.js";

test("metrics are read with their labels", () => {
  const metrics = new Metrics(
    [
      "# HELP a_total Things",
      "# TYPE a_total counter",
      'a_total{reason="one"} 2',
      'a_total{reason="t\\"w\\\\o,}",code="x"} 3.5e+2',
      "b 7",
      'h_bucket{le="+Inf"} 9',
      'h_bucket{le="0.5"} 4',
      "",
    ].join("\n"),
  );
  assert.equal(metrics.sum("a_total"), 352);
  assert.equal(metrics.sum("b"), 7);
  assert.ok(Number.isNaN(metrics.sum("nothing")));
  assert.deepEqual([...metrics.by("a_total", "reason")], [["one", 2], ['t"w\\o,}', 350]]);
  assert.deepEqual(metrics.histogram("h"), { le: [0.5, Infinity], counts: [4, 9] });
});

test("quantiles lie where a histogram's counts have them", () => {
  const le = [1, 2, 4, Infinity];
  // Between the two looks: 10 up to 1, 10 more up to 2.
  assert.equal(quantile(0.5, le, [5, 5, 5, 5], [15, 25, 25, 25]), 1);
  assert.equal(quantile(0.75, le, [5, 5, 5, 5], [15, 25, 25, 25]), 1.5);
  assert.equal(quantile(0.25, le, [0, 0, 0, 0], [10, 20, 20, 20]), 0.5);
  assert.equal(quantile(0.99, le, [0, 0, 0, 0], [0, 0, 0, 3]), 4); // beyond all ends
  assert.equal(quantile(0.5, le, [1, 2, 3, 4], [1, 2, 3, 4]), null);
});

/** What a server says that has rendered so many frames, each in 20 ms, half of it in trace. */
function answer(frames, uptime, more = "") {
  const text = [
    `amalgam_frames_received_total ${2 * frames}`,
    `amalgam_frames_sent_total ${frames}`,
    `amalgam_frames_skipped_total{reason="closed"} ${frames}`,
    `amalgam_render_seconds_count ${frames}`,
    `amalgam_stage_seconds_sum{stage="trace"} ${0.01 * frames}`,
    `amalgam_stage_seconds_sum{stage="real_depth"} ${0.005 * frames}`,
    `amalgam_frame_seconds_bucket{le="0.02"} ${frames}`,
    `amalgam_frame_seconds_bucket{le="+Inf"} ${frames}`,
    `process_cpu_seconds_total ${frames / 20}`,
    "amalgam_queue_age_seconds 0.25",
    "process_resident_memory_bytes 5e8",
    more,
  ].join("\n");
  return [{ uptime_s: uptime }, new Metrics(text)];
}

test("counts become rates and means between two answers", () => {
  const history = new History();
  history.add(100, ...answer(10, 50));
  assert.equal(history.newest("received"), null);
  assert.equal(history.newest("waiting"), 250);
  history.add(102, ...answer(30, 52));
  assert.equal(history.newest("received"), 20);
  assert.equal(history.newest("sent"), 10);
  assert.equal(history.newest("skipped"), 10);
  assert.equal(history.newest("cpu"), 0.5);
  assert.equal(history.newest("memory"), 500);
  assert.ok(Math.abs(history.newest("stage:trace") - 10) < 1e-9);
  assert.equal(history.newest("median"), 10); // the middle of the bucket
  assert.deepEqual(history.stages(), ["trace", "real_depth"]);
  assert.deepEqual(history.column("received"), [null, 20]);
  history.add(104, ...answer(30, 54)); // nothing happened, but within the last seconds it did
  assert.equal(history.newest("received"), 10);
  assert.ok(Math.abs(history.newest("stage:trace") - 10) < 1e-9);
  history.add(108, ...answer(30, 58));
  assert.equal(history.newest("received"), 0);
  assert.equal(history.newest("stage:trace"), null);
});

test("a server that was started anew makes no negative rates", () => {
  const history = new History();
  history.add(100, ...answer(1000, 500));
  history.add(101, ...answer(3, 1));
  assert.equal(history.newest("received"), null);
  history.add(102, ...answer(5, 2));
  assert.equal(history.newest("received"), 4);
});

test("silence is a gap, and only the last minutes are kept", () => {
  const history = new History();
  history.add(0, ...answer(0, 0));
  history.add(1, ...answer(1, 1));
  history.addGap(2);
  history.add(3, ...answer(9, 3));
  assert.deepEqual(history.column("received"), [null, 2, null, null]);
  for (let i = 4; i <= SPAN_S + 100; ++i) history.add(i, ...answer(9 + i, i));
  assert.equal(history.times[0], 100);
  assert.equal(history.times.length, SPAN_S + 1);
  assert.equal(history.column("received").length, history.times.length);
});

test("stacked lines add up, and end where nothing is known", () => {
  const lines = [
    { label: "a", values: [1, null, null] },
    { label: "b", values: [2, 5, null] },
  ];
  assert.deepEqual(stacked(lines), [[1, 0, null], [3, 5, null]]);
});

test("of many stages the longest have lines of their own", () => {
  const history = new History();
  const stages = (scale) =>
    Array.from({ length: 9 }, (_, i) => `amalgam_stage_seconds_sum{stage="s_${i}"} ${i * scale}`);
  history.add(0, ...answer(0, 0, stages(0).join("\n")));
  history.add(1, ...answer(1, 1, stages(0.1).join("\n")));
  const lines = CHARTS.find(({ id }) => id === "stages").lines(history);
  const labels = lines.map(({ label }) => label);
  assert.deepEqual(labels, ["s 8", "s 7", "s 6", "s 5", "s 4", "s 3", "others"]);
  // s_1 and s_2 with 300 ms, and what answer() has itself: 15.
  assert.ok(Math.abs(lines.at(-1).values[1] - 315) < 1e-6, `${lines.at(-1).values[1]}`);
});

test("numbers in words", () => {
  const values = [0, 7, 1.234, 12.34, 123.4];
  assert.deepEqual(values.map(number), ["0", "7", "1.23", "12.3", "123"]);
  assert.equal(number(null), "–");
  assert.equal(bytes(999), "999 B");
  assert.equal(bytes(12_345), "12.3 kB");
  assert.equal(bytes(8.6e9), "8.60 GB");
  assert.equal(duration(59.9), "59 s");
  assert.equal(duration(3725), "1 h 2 min");
  assert.equal(duration(200_000), "2 d 7 h");
  assert.deepEqual(skips({ closed: 0, refused: 2, new_reason: 1 }), [
    ["refused with an error", 2],
    ["new reason", 1],
  ]);
});

test("a stuck renderer is worse than a full server", () => {
  const good = { alive: true, ready: true, not_alive: "", not_ready: "" };
  assert.equal(readiness(good).kind, "ready");
  const full = { ...good, ready: false, not_ready: "full" };
  assert.deepEqual(readiness(full), { kind: "busy", text: "not ready: full" });
  const stuck = { ...full, alive: false, not_alive: "no progress" };
  assert.deepEqual(readiness(stuck), { kind: "refused", text: "stuck: no progress" });
});
