// How long to wait before connecting again. All clients of a server that ends lose it in the same
// moment: the random part keeps them from coming back in the same moment.

const FIRST_MS = 500;
const LONGEST_MS = 15000;

/**
 * @param {number} attempt 0 for the first after a loss
 * @param {() => number} random from 0 to 1
 * @returns {number} ms: between half and all of 0.5 s, 1 s, 2 s ... 15 s
 */
export function backoffMs(attempt, random = Math.random) {
  const most = Math.min(LONGEST_MS, FIRST_MS * 2 ** Math.min(attempt, 20));
  return most * (0.5 + 0.5 * random());
}

/**
 * @param {number} retryAfterMs what a full server asked for
 * @returns {number} ms: never sooner than asked for, and up to a quarter later
 */
export function busyMs(retryAfterMs, random = Math.random) {
  return retryAfterMs * (1 + 0.25 * random());
}
