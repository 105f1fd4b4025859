// How many frames are under way at once. One at a time gives the shortest delay. Two let the server
// work while the next frame travels, which shows more frames, but on a slow server the second one
// only waits. Nobody knows beforehand, so this tries it out.

const WINDOW = 20; // frames that a figure is taken from
const SETTLE = 4; // frames after a change that still belong to what was before
const MAX_DELAY_GROWTH = 1.05; // of the median delay: what measuring noise may be
const MIN_RATE_GROWTH = 1.05; // less is not worth it
const FIRST_PAUSE = 200; // frames before it is tried again
const LONGEST_PAUSE = 3200;

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

export class Pace {
  /** Frames that may be under way now: 1 or 2. */
  limit = 1;
  #toSkip = SETTLE;
  #delays = [];
  #begin = 0;
  #alone = null; // {delay, rate} of one frame at a time
  #pause = 0; // frames until the next trial
  #nextPause = FIRST_PAUSE;

  /**
   * Notes that a composite was shown.
   * @param {number} delayMs from its capture
   * @param {number} nowMs
   */
  shown(delayMs, nowMs) {
    if (this.#pause > 0) {
      --this.#pause;
      if (this.#pause === 0) this.#measureAt(1);
      return;
    }
    if (this.#toSkip > 0) {
      --this.#toSkip;
      this.#begin = nowMs;
      return;
    }
    this.#delays.push(delayMs);
    if (this.#delays.length === WINDOW) this.#judge(nowMs);
  }

  #judge(nowMs) {
    const figures = {
      delay: median(this.#delays),
      rate: WINDOW / Math.max(nowMs - this.#begin, 1),
    };
    if (this.limit === 1) {
      this.#alone = figures;
      this.#measureAt(2);
      return;
    }
    const good =
      figures.delay <= MAX_DELAY_GROWTH * this.#alone.delay &&
      figures.rate >= MIN_RATE_GROWTH * this.#alone.rate;
    if (!good) this.limit = 1;
    this.#pause = this.#nextPause;
    this.#nextPause = good ? FIRST_PAUSE : Math.min(2 * this.#nextPause, LONGEST_PAUSE);
  }

  #measureAt(limit) {
    this.limit = limit;
    this.#toSkip = SETTLE;
    this.#delays = [];
  }
}
