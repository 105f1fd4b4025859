// An 8-bit grey image. Pixel (0, 0) is the centre of the top left pixel.

export class GreyImage {
  /** @param {Uint8Array} data width * height values, row by row */
  constructor(width, height, data = new Uint8Array(width * height)) {
    this.width = width;
    this.height = height;
    this.data = data;
  }

  /** @param {Uint8ClampedArray} rgba 4 bytes a pixel; BT.601's weights, as OpenCV's */
  setFromRgba(rgba) {
    const { data } = this;
    for (let i = 0, from = 0; i < data.length; ++i, from += 4) {
      // 16 bits of fraction.
      data[i] = (19595 * rgba[from] + 38470 * rgba[from + 1] + 7471 * rgba[from + 2] + 32768) >> 16;
    }
  }

  /** @returns {number} between four pixels; NaN outside of the image */
  at(x, y) {
    if (!(x >= 0 && y >= 0 && x < this.width - 1 && y < this.height - 1)) return NaN;
    const left = Math.floor(x);
    const top = Math.floor(y);
    const fx = x - left;
    const fy = y - top;
    const { data, width } = this;
    const i = top * width + left;
    const upper = data[i] + (data[i + 1] - data[i]) * fx;
    const lower = data[i + width] + (data[i + width + 1] - data[i + width]) * fx;
    return upper + (lower - upper) * fy;
  }
}
