// Draws the board for measuring lenses as a camera without distortion sees it, each pixel the mean
// of several samples.
import { patternRows } from "amalgam-page/markers/dictionary.js";
import { GreyImage } from "amalgam-page/markers/grey_image.js";
import table from "amalgam-page/markers/opencv.json";
import { product, rotationBy } from "amalgam-page/lens/projection.js";
import { FACING } from "./held_board.js";

const SAMPLES = 3; // along each side of a pixel
const WHITE = 220;
const BLACK = 30;

/** @returns {(x: number, y: number) => number} the grey of a point of the board, metres */
function boardGreys(board, dictionary) {
  const { side } = board.black[0];
  const columns = Math.round(board.width / side);
  const rows = Math.round(board.height / side);
  const markers = new Map();
  for (const [id, corners] of board.markers) {
    const column = Math.floor((corners[0].x + board.width / 2) / side);
    const row = Math.floor((board.height / 2 - corners[0].y) / side);
    markers.set(`${column},${row}`, { corners, pattern: patternRows(table, dictionary, id) });
  }
  return (x, y) => {
    const column = Math.floor((x + board.width / 2) / side);
    const row = Math.floor((board.height / 2 - y) / side);
    if (column < 0 || row < 0 || column >= columns || row >= rows) return WHITE;
    if ((column + row) % 2 === 0) return BLACK;
    const { corners, pattern } = markers.get(`${column},${row}`);
    const cell = (corners[1].x - corners[0].x) / (pattern.length + 2);
    const u = Math.floor((x - corners[0].x) / cell);
    const v = Math.floor((corners[0].y - y) / cell);
    if (u < 0 || v < 0 || u >= pattern.length + 2 || v >= pattern.length + 2) return WHITE;
    return pattern[v - 1]?.[u - 1] === "1" ? WHITE : BLACK;
  };
}

// The inverse of a 3 x 3 matrix, but for its scale.
function adjugate([[a, b, c], [d, e, f], [g, h, i]]) {
  return [
    [e * i - f * h, c * h - b * i, b * f - c * e],
    [f * g - d * i, a * i - c * g, c * d - a * f],
    [d * h - e * g, b * g - a * h, a * e - b * d],
  ];
}

/**
 * @param {{width: number, height: number, focal: number}} camera that looks at its middle
 * @param {Board} board
 * @param {string} dictionary
 * @param {{tilt: number[], position: number[]}} hold as of held_board.js
 * @returns {GreyImage}
 */
export function drawBoard({ width, height, focal }, board, dictionary, { tilt, position }) {
  const greyOf = boardGreys(board, dictionary);
  const rotation = product(rotationBy(tilt), FACING);
  const [cx, cy] = [(width - 1) / 2, (height - 1) / 2];
  // From the board's plane to pixels: K [r1 r2 t].
  const plane = rotation.map((row, i) => [row[0], row[1], position[i]]);
  const toPixels = [
    [0, 1, 2].map((j) => focal * plane[0][j] + cx * plane[2][j]),
    [0, 1, 2].map((j) => focal * plane[1][j] + cy * plane[2][j]),
    plane[2],
  ];
  const back = adjugate(toPixels);
  const image = new GreyImage(width, height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      let sum = 0;
      for (let i = 0; i < SAMPLES * SAMPLES; ++i) {
        const px = x + ((i % SAMPLES) + 0.5) / SAMPLES - 0.5;
        const py = y + (Math.floor(i / SAMPLES) + 0.5) / SAMPLES - 0.5;
        const w = back[2][0] * px + back[2][1] * py + back[2][2];
        const u = (back[0][0] * px + back[0][1] * py + back[0][2]) / w;
        const v = (back[1][0] * px + back[1][1] * py + back[1][2]) / w;
        sum += greyOf(u, v);
      }
      image.data[y * width + x] = Math.round(sum / SAMPLES ** 2);
    }
  }
  return image;
}
