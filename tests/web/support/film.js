// Films for a browser's camera, as Y4M: the pictures are repeated for as long as somebody looks.
// A browser takes its camera's values for BT.601's narrow range, 16 to 235, whatever the file says.
// (With MJPEG, whose range is the full one, bright colors would be cut off.)
import { writeFileSync } from "node:fs";

const fixed = (value) => Math.min(255, Math.max(0, Math.round(value)));

// RGBA, 4 bytes a pixel, to the planes Y, U and V; U and V have half the size on each axis.
function planes({ width, height, data }) {
  const y = Buffer.alloc(width * height);
  const u = Buffer.alloc((width * height) / 4);
  const v = Buffer.alloc((width * height) / 4);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const at = row * width + column;
      const [r, g, b] = data.subarray(4 * at, 4 * at + 3);
      y[at] = fixed(16 + (65.481 * r + 128.553 * g + 24.966 * b) / 255);
    }
  }
  for (let row = 0; row < height; row += 2) {
    for (let column = 0; column < width; column += 2) {
      const block = [0, 1, width, width + 1].map((i) => 4 * (row * width + column + i));
      const [r, g, b] = [0, 1, 2].map((c) => block.reduce((sum, i) => sum + data[i + c], 0) / 4);
      const at = (row / 2) * (width / 2) + column / 2;
      u[at] = fixed(128 + (-37.797 * r - 74.203 * g + 112 * b) / 255);
      v[at] = fixed(128 + (112 * r - 93.786 * g - 18.214 * b) / 255);
    }
  }
  return [y, u, v];
}

/**
 * @param {string} file
 * @param {{width: number, height: number, data: Uint8Array}[]} pictures RGBA, of one size, even on
 *   both axes
 * @param {number} rate pictures a second
 */
export function writeFilm(file, pictures, rate = 30) {
  const { width, height } = pictures[0];
  const head = Buffer.from(`YUV4MPEG2 W${width} H${height} F${rate}:1 Ip A1:1 C420jpeg\n`);
  const frames = pictures.flatMap((picture) => [Buffer.from("FRAME\n"), ...planes(picture)]);
  writeFileSync(file, Buffer.concat([head, ...frames]));
}

/** @returns {object} a GreyImage as a picture for writeFilm() */
export function colored({ width, height, data }) {
  const rgba = new Uint8Array(4 * data.length);
  data.forEach((value, i) => rgba.fill(value, 4 * i, 4 * i + 4));
  return { width, height, data: rgba };
}
