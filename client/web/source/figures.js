// Counts frames and averages their times. Knows nothing of the page, so that it can be tested.

const SMOOTHING = 0.1; // share of the newest frame in an average
const RATE_WINDOW_MS = 2000;
export const LATE_MS = 300;

export class Figures {
  shown = 0;
  late = 0; // shown more than LATE_MS after their capture
  skipped = 0; // not sent, because others were under way
  lost = 0; // sent and not answered
  #averages = new Map();
  #times = [];

  /**
   * @param {object} composite
   * @param {object} frame of frame_loop.js
   * @param {{received: number, decoded: number, shown: number}} at ms
   */
  add(composite, frame, at) {
    const delay = at.shown - frame.captured;
    ++this.shown;
    if (delay > LATE_MS) ++this.late;
    this.#times.push(at.shown);
    const { read, search, encode } = frame.times;
    const stages = {
      wait: Math.max(0, frame.sent - frame.captured - read - search - encode),
      read,
      search,
      encode,
      network: Math.max(0, at.received - frame.sent - composite.serverMs),
      server: composite.serverMs,
      decode: at.decoded - at.received,
      show: at.shown - at.decoded,
      total: delay,
    };
    for (const [name, value] of Object.entries(stages)) this.#average(name, value);
    const running = new Set(composite.stages.map(({ name }) => `server/${name}`));
    for (const name of this.#averages.keys()) {
      if (name.startsWith("server/") && !running.has(name)) this.#averages.delete(name);
    }
    for (const { name, milliseconds } of composite.stages) {
      if (name === "total") continue; // that is no stage, but their sum
      this.#average(`server/${name}`, milliseconds);
    }
  }

  /** @returns {number} ms; NaN before the first frame */
  average(name) {
    return this.#averages.get(name) ?? NaN;
  }

  /** @returns {[string, number][]} the server's stages that took longest, ms, the longest first */
  serverStages() {
    return [...this.#averages]
      .filter(([name]) => name.startsWith("server/"))
      .map(([name, value]) => [name.slice("server/".length), value])
      .sort((a, b) => b[1] - a[1]);
  }

  /** @returns {number} composites shown a second */
  rate(now) {
    this.#times = this.#times.filter((time) => now - time <= RATE_WINDOW_MS);
    return this.#times.length / (RATE_WINDOW_MS / 1000);
  }

  #average(name, value) {
    const last = this.#averages.get(name);
    this.#averages.set(name, last === undefined ? value : last + SMOOTHING * (value - last));
  }
}
