// Asks the server for /state and /metrics each second, again and again, whatever happens.
import { Metrics } from "./metrics_text.js";

const PERIOD_MS = 1000;
const TIMEOUT_MS = 3000;

async function text(path) {
  const signal = AbortSignal.timeout(TIMEOUT_MS);
  const response = await fetch(path, { cache: "no-store", signal });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  return response.text();
}

export class Poller {
  #on;
  #silentSince = null;

  /**
   * @param {object} on answered(state, metrics, time), silent(since, time); times in ms of
   *   Date.now()
   */
  constructor(on) {
    this.#on = on;
  }

  async run() {
    for (;;) {
      const begin = Date.now();
      await this.#ask();
      const rest = PERIOD_MS - (Date.now() - begin);
      await new Promise((resolve) => setTimeout(resolve, Math.max(rest, 100)));
    }
  }

  async #ask() {
    const begin = Date.now();
    let answers;
    try {
      answers = await Promise.all([text("state"), text("metrics")]);
      answers = [JSON.parse(answers[0]), new Metrics(answers[1])];
    } catch {
      this.#silentSince ??= begin;
      this.#on.silent(this.#silentSince, Date.now());
      return;
    }
    this.#silentSince = null;
    this.#on.answered(...answers, Date.now());
  }
}
