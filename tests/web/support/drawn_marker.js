// Draws a marker by its formula: a printed pattern seen under a projective map, each pixel the mean
// of many samples, as a sensor takes it.
import { patternRows } from "amalgam-page/markers/dictionary.js";
import { GreyImage } from "amalgam-page/markers/grey_image.js";
import table from "amalgam-page/markers/opencv.json";

const SAMPLES = 8; // along each side of a pixel
const WHITE = 220;
const BLACK = 30;

// The map from the quadrangle back to the unit square: the inverse of the homography by which
// (0,0), (1,0), (1,1), (0,1) go to the corners, from the eight linear equations for it.
function quadrangleToSquare(corners) {
  const targets = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const rows = corners.flatMap(({ x, y }, i) => {
    const [u, v] = targets[i];
    return [
      [x, y, 1, 0, 0, 0, -u * x, -u * y, u],
      [0, 0, 0, x, y, 1, -v * x, -v * y, v],
    ];
  });
  for (let i = 0; i < 8; ++i) {
    const pivot = rows.slice(i).reduce((a, b) => (Math.abs(a[i]) > Math.abs(b[i]) ? a : b));
    rows.splice(rows.indexOf(pivot), 1);
    rows.splice(i, 0, pivot);
    for (let j = 0; j < 8; ++j) {
      if (j === i) continue;
      const factor = rows[j][i] / pivot[i];
      for (let k = i; k < 9; ++k) rows[j][k] -= factor * pivot[k];
    }
  }
  const h = rows.map((row, i) => row[8] / row[i]);
  return (x, y) => {
    const w = h[6] * x + h[7] * y + 1;
    return [(h[0] * x + h[1] * y + h[2]) / w, (h[3] * x + h[4] * y + h[5]) / w];
  };
}

/** @returns {string[]} rows of "0" (black) and "1" (white), without the border */
export const patternOf = (dictionary, id) => patternRows(table, dictionary, id);

/**
 * @param {string[]} pattern rows of "0" (black) and "1" (white), without the border
 * @param {{x: number, y: number}[]} corners of the printed marker: top left, top right, bottom
 *   right, bottom left; pixel (0, 0) is the centre of the top left pixel
 * @returns {GreyImage}
 */
export function drawMarker(pattern, corners, width, height) {
  const toSquare = quadrangleToSquare(corners);
  const cells = pattern.length + 2;
  const colorAt = (x, y) => {
    const [u, v] = toSquare(x, y);
    if (u < 0 || v < 0 || u >= 1 || v >= 1) return WHITE;
    const bit = pattern[Math.floor(v * cells) - 1]?.[Math.floor(u * cells) - 1];
    return bit === "1" ? WHITE : BLACK;
  };
  const image = new GreyImage(width, height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      let sum = 0;
      for (let i = 0; i < SAMPLES * SAMPLES; ++i) {
        const dx = ((i % SAMPLES) + 0.5) / SAMPLES - 0.5;
        const dy = (Math.floor(i / SAMPLES) + 0.5) / SAMPLES - 0.5;
        sum += colorAt(x + dx, y + dy);
      }
      image.data[y * width + x] = Math.round(sum / SAMPLES ** 2);
    }
  }
  return image;
}
