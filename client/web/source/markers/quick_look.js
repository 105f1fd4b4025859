// A first look for markers at half the size, at a quarter of the time. It finds those that are large
// in the picture, which are most of the ones that people hold a camera at.
import { CandidateSearch, RADII } from "./candidates.js";
import { GreyImage } from "./grey_image.js";

// Pixels of the whole picture for a bit of a marker's pattern. With less, corners found at half the
// size are too far off for their edges to be found (refinement.js).
const LEAST_BIT = 4;
// While looks find too little, most pictures are spared them.
const MISSES = 3;
const PAUSE = 8;

export class QuickLook {
  #half;
  #search;
  #misses = 0;
  #pictures = 0;

  constructor(width, height) {
    this.#half = new GreyImage(Math.floor(width / 2), Math.floor(height / 2));
    this.#search = new CandidateSearch(this.#half.width, this.#half.height);
  }

  /** Whether to look at the next picture. */
  get isDue() {
    return this.#misses < MISSES || this.#pictures++ % PAUSE === 0;
  }

  /** @param {boolean} enough whether the last look found all that was wanted */
  note(enough) {
    this.#misses = enough ? 0 : this.#misses + 1;
  }

  /**
   * @param {GreyImage} grey
   * @param {number} bits of the pattern along a side, without its border of one bit
   * @returns {{x: number, y: number}[][]} as CandidateSearch.find(), in grey's pixels
   */
  find(grey, bits) {
    this.#shrink(grey);
    const least = LEAST_BIT * (bits + 2);
    return this.#search
      .find(this.#half, RADII[0])
      .map((corners) => corners.map(({ x, y }) => ({ x: 2 * x + 0.5, y: 2 * y + 0.5 })))
      .filter((corners) => shortestSide(corners) >= least);
  }

  #shrink({ data, width }) {
    const { data: small, width: columns, height: rows } = this.#half;
    for (let row = 0, to = 0; row < rows; ++row) {
      let from = 2 * row * width;
      for (let column = 0; column < columns; ++column, from += 2) {
        const upper = data[from] + data[from + 1];
        small[to++] = (upper + data[from + width] + data[from + width + 1] + 2) >> 2;
      }
    }
  }
}

function shortestSide(corners) {
  return Math.min(
    ...corners.map(({ x, y }, i) => {
      const next = corners[(i + 1) % 4];
      return Math.hypot(next.x - x, next.y - y);
    }),
  );
}
