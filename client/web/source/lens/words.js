// What the page says while it measures a lens.
import limits from "./limits.json";

const ADVICE = {
  taken: "Taken. Turn or move the board.",
  likeAnother: "Turn or move the board.",
  fewMarkers: "Show it more of the board.",
  full: "That is enough.",
};

/** @param {{offer: string, views: number, coverage: number}} view as the worker tells it */
export function viewWords({ offer, views, coverage }) {
  const share = `${(100 * coverage).toFixed(0)} %`;
  const missing = Math.max(limits.fewestViews - views, 0);
  const more = missing > 0 ? ` At least ${missing} more.` : "";
  return `${views} views, in ${share} of the picture. ${ADVICE[offer]}${more}`;
}

/** @param {{error: number, tilt: number}} lens; degrees: how wide it sees */
export function lensWords({ error, tilt }, degrees) {
  return (
    `The lens is ${degrees.toFixed(1)}° wide. Corners lie ${error.toFixed(2)} pixels from where ` +
    `it has them; the board was turned by ${tilt.toFixed(0)}°.`
  );
}
