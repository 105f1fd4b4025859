// Views of the board that a known lens gives, as people hold it.
import { rotationBy, moved, product, project } from "amalgam-page/lens/projection.js";

// A board that faces the camera: its y is up, the picture's is down.
export const FACING = [
  [1, 0, 0],
  [0, -1, 0],
  [0, 0, -1],
];

/** @returns {() => number} the same numbers from 0 to 1 each time [Lehmer's, of C++'s minstd] */
export function randomNumbers(seed = 1) {
  let state = seed;
  return () => {
    state = (48271 * state) % 2147483647;
    return state / 2147483647;
  };
}

/**
 * @param {{width: number, height: number, lens: number[]}} camera lens: as in projection.js
 * @param {Board} board
 * @param {number[]} tilt rotation vector, radians
 * @param {number[]} position of the board's middle, metres
 * @param {{noise?: number, random?: () => number}} jitter noise: pixels, standard deviation
 * @returns {Marker[]} those that lie in the picture
 */
export function boardView(camera, board, tilt, position, { noise = 0, random } = {}) {
  const pose = { rotation: product(rotationBy(tilt), FACING), translation: position };
  const { width, height, lens } = camera;
  // The sum of twelve has a standard deviation of 1.
  const jitter = () =>
    noise === 0 ? 0 : noise * (Array.from({ length: 12 }, random).reduce((a, b) => a + b) - 6);
  const markers = [];
  for (const [id, corners] of board.markers) {
    const pixels = corners.map(({ x, y }) => project(lens, moved(pose, [x, y])));
    const inside = pixels.every(([x, y]) => x > 0 && y > 0 && x < width - 1 && y < height - 1);
    if (!inside) continue;
    markers.push({ id, corners: pixels.map(([x, y]) => ({ x: x + jitter(), y: y + jitter() })) });
  }
  return markers;
}

/** @returns {{tilt: number[], position: number[]}[]} into all corners, turned both ways */
export function goodHolds() {
  const holds = [];
  for (const x of [-0.1, 0, 0.1]) {
    for (const y of [-0.06, 0, 0.06]) {
      for (const z of [0.28, 0.36]) {
        const i = holds.length;
        const a = 0.35 * ((i % 3) - 1);
        const b = 0.4 * ((Math.floor(i / 2) % 3) - 1);
        holds.push({ tilt: [a, b, 0.1 * i], position: [x, y, z] });
      }
    }
  }
  return holds;
}
