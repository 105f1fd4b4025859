// Reads the pattern of black and white bits inside a quadrangle.
import { squareToQuadrangle } from "./homography.js";

const SAMPLES = 4; // of a bit, along each side
const MARGIN = 0.2; // of a bit on each side is not looked at: there the neighbours blur in
const MIN_DEVIATION = 5; // grey levels, below which a quadrangle is of one color
const MAX_BORDER_ERRORS = 0.35; // of the border's bits may look white, as OpenCV's default

// The grey level that parts dark from bright best [N. Otsu, A Threshold Selection Method from
// Gray-Level Histograms, 1979].
function otsu(values) {
  const sorted = Float32Array.from(values).sort();
  const total = sorted.reduce((sum, value) => sum + value, 0);
  let below = 0;
  let best = 0;
  let threshold = sorted[0];
  for (let n = 1; n < sorted.length; ++n) {
    below += sorted[n - 1];
    const difference = below / n - (total - below) / (sorted.length - n);
    const between = n * (sorted.length - n) * difference * difference;
    if (between > best) {
      best = between;
      threshold = (sorted[n - 1] + sorted[n]) / 2;
    }
  }
  return threshold;
}

function deviation(values) {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const square = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return Math.sqrt(square / values.length);
}

// Mean grey of each bit, border included, row by row.
function bitMeans(grey, corners, cells) {
  const map = squareToQuadrangle(corners);
  const means = new Float32Array(cells * cells);
  for (let row = 0; row < cells; ++row) {
    for (let column = 0; column < cells; ++column) {
      let sum = 0;
      for (let i = 0; i < SAMPLES * SAMPLES; ++i) {
        const du = MARGIN + ((1 - 2 * MARGIN) * ((i % SAMPLES) + 0.5)) / SAMPLES;
        const dv = MARGIN + ((1 - 2 * MARGIN) * (Math.floor(i / SAMPLES) + 0.5)) / SAMPLES;
        const { x, y } = map((column + du) / cells, (row + dv) / cells);
        sum += grey.at(x, y);
      }
      means[row * cells + column] = sum / (SAMPLES * SAMPLES);
    }
  }
  return means;
}

/**
 * @param {GreyImage} grey
 * @param {{x: number, y: number}[]} corners clockwise on the screen
 * @param {number} bits of the pattern along a side, without its border of one bit
 * @returns {bigint | null} as a Dictionary's, read from the first corner on; null if there is no
 *   black border, or part of it lies outside of the image
 */
export function readPattern(grey, corners, bits) {
  const cells = bits + 2;
  const means = bitMeans(grey, corners, cells);
  if (!(deviation(means) >= MIN_DEVIATION)) return null; // NaN: outside of the image
  const threshold = otsu(means);
  let pattern = 0n;
  let borderErrors = 0;
  for (let i = 0; i < means.length; ++i) {
    const row = Math.floor(i / cells);
    const column = i % cells;
    const white = means[i] > threshold;
    const border = row === 0 || column === 0 || row === cells - 1 || column === cells - 1;
    if (!border) pattern = (pattern << 1n) | (white ? 1n : 0n);
    else if (white) ++borderErrors;
  }
  const borderBits = 4 * (cells - 1);
  return borderErrors <= MAX_BORDER_ERRORS * borderBits ? pattern : null;
}
