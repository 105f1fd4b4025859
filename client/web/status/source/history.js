// The last minutes, as columns for charts: what the server counts becomes rates and means between
// two looks at it. Knows nothing of the page, so that it can be tested.
import { quantile } from "./quantile.js";

export const SPAN_S = 300;
// Rates and means are over so long, as those of /state: a slow server has no frame in many seconds.
const MEAN_SPAN_S = 5;
// Of so few frames as one second has, a 99th percentile would be the slowest one.
const QUANTILE_SPAN_S = 10;
const ABSENT = null; // a gap in a line

export class History {
  #samples = []; // raw, the oldest first; enough for quantiles
  #columns = new Map(); // name -> values, as long as #times
  #times = []; // s, of Date.now()

  get times() {
    return this.#times;
  }

  /** @returns {(number | null)[]} */
  column(name) {
    return this.#columns.get(name) ?? this.#times.map(() => ABSENT);
  }

  /** @returns {number | null} */
  newest(name) {
    return this.column(name).at(-1) ?? ABSENT;
  }

  /** @returns {string[]} names of stages that took time, the longest first; of all that is kept */
  stages() {
    const names = [...this.#columns.keys()].filter((name) => name.startsWith("stage:"));
    const sum = (name) => this.column(name).reduce((total, value) => total + (value ?? 0), 0);
    return names
      .map((name) => [name.slice("stage:".length), sum(name)])
      .filter(([, total]) => total > 0)
      .sort(([, a], [, b]) => b - a)
      .map(([name]) => name);
  }

  /**
   * @param {number} time s
   * @param {object} state of /state
   * @param {import("./metrics_text.js").Metrics} metrics
   */
  add(time, state, metrics) {
    const sample = sampleOf(time, state, metrics);
    const before = this.#samples.at(-1);
    if (before && sample.uptime < before.uptime) this.#samples = []; // it was started anew
    const first =
      this.#samples.find((earlier) => earlier.time >= time - MEAN_SPAN_S) ?? this.#samples.at(-1);
    this.#samples.push(sample);
    while (this.#samples[0].time < time - QUANTILE_SPAN_S) this.#samples.shift();
    this.#append(time, { ...gauges(state, metrics), ...(first && between(first, sample)) });
    if (first) this.#setQuantiles(sample);
  }

  /** The server did not answer. */
  addGap(time) {
    this.#samples = [];
    this.#append(time, {});
  }

  #setQuantiles(sample) {
    const [first] = this.#samples;
    const { le, counts } = sample.delays;
    for (const [name, part] of [
      ["median", 0.5],
      ["p99", 0.99],
    ]) {
      const seconds = quantile(part, le, first.delays.counts, counts);
      this.#set(name, seconds === null ? ABSENT : 1000 * seconds); // ms
    }
  }

  #set(name, value) {
    if (!this.#columns.has(name)) this.#columns.set(name, this.#times.map(() => ABSENT));
    // What a server of another version does not measure is no number.
    this.#columns.get(name)[this.#times.length - 1] = Number.isFinite(value) ? value : ABSENT;
  }

  #append(time, values) {
    this.#times.push(time);
    for (const column of this.#columns.values()) column.push(ABSENT);
    for (const [name, value] of Object.entries(values)) this.#set(name, value);
    while (this.#times[0] < time - SPAN_S) {
      this.#times.shift();
      for (const column of this.#columns.values()) column.shift();
    }
  }
}

function sampleOf(time, state, metrics) {
  return {
    time,
    uptime: state.uptime_s,
    received: metrics.sum("amalgam_frames_received_total"),
    sent: metrics.sum("amalgam_frames_sent_total"),
    skipped: metrics.sum("amalgam_frames_skipped_total"),
    cpu: metrics.sum("process_cpu_seconds_total"),
    rendered: metrics.sum("amalgam_render_seconds_count"),
    stages: metrics.by("amalgam_stage_seconds_sum", "stage"),
    delays: metrics.histogram("amalgam_frame_seconds"),
  };
}

function gauges(state, metrics) {
  return {
    connections: metrics.sum("amalgam_connections"),
    sessions: metrics.sum("amalgam_sessions"),
    waiting: 1000 * metrics.sum("amalgam_queue_age_seconds"), // ms
    memory: metrics.sum("process_resident_memory_bytes") / 1e6, // MB
  };
}

function between(a, b) {
  const seconds = Math.max(b.time - a.time, 1e-3);
  const values = {};
  for (const name of ["received", "sent", "skipped", "cpu"]) {
    values[name] = (b[name] - a[name]) / seconds;
  }
  const frames = b.rendered - a.rendered;
  if (frames > 0) {
    for (const [stage, sum] of b.stages) {
      values[`stage:${stage}`] = (1000 * (sum - (a.stages.get(stage) ?? 0))) / frames; // ms
    }
  }
  return values;
}
