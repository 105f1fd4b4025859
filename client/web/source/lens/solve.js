// A lens from views of the board, or in plain words why they do not determine it: the same limits
// and the same model as amalgam-client --calibrate (client/tracking/lens_calibration.cpp).
import { firstGuess } from "./first_guess.js";
import limits from "./limits.json";
import { refine } from "./refine.js";

const degrees = (radians) => (radians * 180) / Math.PI;
const percent = (share) => `${(100 * share).toFixed(0)} %`;

// Degrees between the two views that differ most, by the board's normal.
function widestTilt(poses) {
  const normals = poses.map(({ rotation }) => rotation.map((row) => row[2]));
  const cosine = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const least = Math.min(...normals.flatMap((a) => normals.map((b) => cosine(a, b))));
  return degrees(Math.acos(Math.min(Math.max(least, -1), 1)));
}

// What the server would refuse (common/camera_model.h).
function isUsable({ width, height, fx, fy, cx, cy, distortion }) {
  const focal = [fx, fy].every((f) => f >= 1 && f <= 1e6);
  const centre = Math.abs(cx) <= 10 * width && Math.abs(cy) <= 10 * height;
  return focal && centre && distortion.every(Number.isFinite);
}

/**
 * @param {Views} views
 * @returns {{camera: object, error: number, tilt: number}} camera: as Hello.camera; error: of all
 *   corners, pixels, root mean square; tilt: degrees between the most different views. Throws an
 *   Error that says what is wrong with the set.
 */
export function solveLens(views, width, height) {
  const { taken, coverage } = views;
  if (taken.length < limits.fewestViews) {
    throw new Error(
      `${taken.length} different views of the board; ${limits.fewestViews} are needed.`,
    );
  }
  if (coverage < limits.leastCoverage) {
    throw new Error(
      `The board was seen in ${percent(coverage)} of the picture; ` +
        `${percent(limits.leastCoverage)} are needed: hold it into the corners too.`,
    );
  }
  const { lens, poses, sum } = refine(taken, firstGuess(taken, width, height));
  const error = Math.sqrt(sum / taken.reduce((count, view) => count + view.length, 0));
  const tilt = widestTilt(poses);
  if (!(tilt >= limits.leastTilt)) {
    throw new Error(
      `All views are alike: the board was turned by ${tilt.toFixed(0)} degrees; ` +
        `${limits.leastTilt} are needed.`,
    );
  }
  if (!(error <= (limits.worstError * width) / limits.usualWidth)) {
    throw new Error(
      `The views contradict each other by ${error.toFixed(1)} pixels: the board is bent, the ` +
        "pictures are blurred, or the camera focused anew in between.",
    );
  }
  const [fx, fy, cx, cy, ...distortion] = lens;
  const camera = { width, height, fx, fy, cx, cy, distortion };
  if (!isUsable(camera)) throw new Error("The views give no lens that can be used.");
  return { camera, error, tilt };
}
