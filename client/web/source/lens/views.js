// Views of the board from which a lens will follow: chooses among pictures and says what is still
// missing. The same rules as the native client's (client/tracking/lens_calibration.cpp), and by the
// same numbers, which a test of it compares with limits.json.
import limits from "./limits.json";

/**
 * key: the same corner's is equal
 * @typedef {{board: number[], pixel: number[], key: string}} Point
 */

const keyOf = (marker, corner) => `${marker}/${corner}`;

export class Views {
  /** @type {Point[][]} */
  taken = [];
  /** Of the picture's cells, row by row, which have had a corner in them. */
  seen = new Array(limits.cells * limits.cells).fill(false);
  #board;
  #width;
  #height;

  /**
   * @param {Board} board
   * @param {number} width of the pictures, pixels
   */
  constructor(board, width, height) {
    this.#board = board;
    this.#width = width;
    this.#height = height;
  }

  /**
   * @param {Marker[]} markers found in a picture
   * @returns {"taken" | "fewMarkers" | "likeAnother" | "full"} what became of it
   */
  offer(markers) {
    if (this.taken.length >= limits.mostViews) return "full";
    const view = this.#pointsOf(markers);
    const fewest = 4 * Math.min(limits.fewestMarkers, this.#board.markers.size);
    if (view.length < fewest) return "fewMarkers";
    if (this.taken.some((other) => this.#isLike(view, other))) return "likeAnother";
    for (const { pixel } of view) this.seen[this.#cellOf(pixel)] = true;
    this.taken.push(view);
    return "taken";
  }

  /** @returns {number} share of the picture's cells */
  get coverage() {
    return this.seen.filter(Boolean).length / this.seen.length;
  }

  /** Whether more pictures would add little. */
  get isEnough() {
    const { length } = this.taken;
    const good = length >= limits.goodViews && this.coverage >= limits.goodCoverage;
    return length >= limits.mostViews || good;
  }

  #pointsOf(markers) {
    const points = [];
    for (const { id, corners } of markers) {
      const known = this.#board.markers.get(id);
      known?.forEach((corner, i) => {
        const pixel = [corners[i].x, corners[i].y];
        points.push({ board: [corner.x, corner.y], pixel, key: keyOf(id, i) });
      });
    }
    return points;
  }

  // By the corners that both have.
  #isLike(view, other) {
    const pixels = new Map(other.map(({ key, pixel }) => [key, pixel]));
    let distance = 0;
    let shared = 0;
    for (const { key, pixel } of view) {
      const same = pixels.get(key);
      if (!same) continue;
      distance += Math.hypot(pixel[0] - same[0], pixel[1] - same[1]);
      ++shared;
    }
    return shared > 0 && distance < limits.moved * this.#width * shared;
  }

  #cellOf([x, y]) {
    const cell = (at, size) =>
      Math.min(Math.max(Math.floor((at * limits.cells) / size), 0), limits.cells - 1);
    return cell(y, this.#height) * limits.cells + cell(x, this.#width);
  }
}
