// A quantile of what a histogram counted between two looks at it, as histogram_quantile() of
// Prometheus estimates it: within a bucket all values are taken for equally likely.

/**
 * @param {number} part 0..1
 * @param {number[]} le upper ends of the buckets, rising; the last is Infinity
 * @param {number[]} before cumulated counts at the first look
 * @param {number[]} after and at the second
 * @returns {number | null} null: nothing was counted
 */
export function quantile(part, le, before, after) {
  const counts = after.map((count, i) => count - (before[i] ?? 0));
  const total = counts.at(-1) ?? 0;
  if (!(total > 0)) return null;
  const rank = part * total;
  const bucket = counts.findIndex((count) => count >= rank);
  // What is beyond the last end is as long as that, at least.
  if (bucket === le.length - 1) return le.at(-2) ?? null;
  const below = bucket > 0 ? counts[bucket - 1] : 0;
  const low = bucket > 0 ? le[bucket - 1] : 0;
  return low + ((le[bucket] - low) * (rank - below)) / (counts[bucket] - below);
}
