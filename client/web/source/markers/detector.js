// Finds the markers of one dictionary in grey images.
import { CandidateSearch, RADII } from "./candidates.js";
import { Dictionary } from "./dictionary.js";
import { readPattern } from "./pattern.js";
import { QuickLook } from "./quick_look.js";
import { refineCorners } from "./refinement.js";

/**
 * @typedef {object} Marker
 * @property {number} id
 * @property {{x: number, y: number}[]} corners of the black square, pixels: the printed marker's
 *   top left, top right, bottom right and bottom left one
 */

export class Detector {
  #dictionary;
  #search;
  #quick;
  #ids;

  /**
   * @param {object} table opencv.json
   * @param {string} dictionary OpenCV's name
   * @param {number[]} ids that are looked for; none: all of the dictionary
   */
  constructor(table, dictionary, width, height, ids = []) {
    this.#dictionary = new Dictionary(table, dictionary);
    this.#search = new CandidateSearch(width, height);
    this.#quick = new QuickLook(width, height);
    this.#ids = new Set(ids);
  }

  /**
   * @param {GreyImage} grey of the size given to the constructor
   * @returns {Marker[]} an id may occur more than once, if the marker is there more than once
   */
  detect(grey) {
    const found = [];
    const read = (outlines) => {
      for (const outline of outlines) {
        const marker = this.#read(grey, outline, found);
        if (marker) found.push(marker);
      }
      return this.#isComplete(found);
    };
    // Who looks for all of a dictionary never has enough.
    if (this.#ids.size > 0 && this.#quick.isDue) {
      const enough = read(this.#quick.find(grey, this.#dictionary.bits));
      this.#quick.note(enough);
      if (enough) return found;
    }
    for (const radius of RADII) {
      if (read(this.#search.find(grey, radius))) break;
    }
    return found;
  }

  #read(grey, outline, found) {
    // The same marker, found with another threshold or by its inner outline.
    if (found.some((marker) => isInside(centre(outline), marker.corners))) return null;
    const pattern = readPattern(grey, outline, this.#dictionary.bits);
    const match = pattern === null ? null : this.#dictionary.find(pattern);
    if (!match || (this.#ids.size > 0 && !this.#ids.has(match.id))) return null;
    // Its top left corner has moved on clockwise by as many corners as quarters.
    const corners = outline.map((_, i) => outline[(i + match.quarters) % 4]);
    return { id: match.id, corners: refineCorners(grey, this.#dictionary.bits, corners) };
  }

  #isComplete(found) {
    if (this.#ids.size === 0) return false;
    return [...this.#ids].every((id) => found.some((marker) => marker.id === id));
  }
}

function centre(corners) {
  const sum = corners.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }), { x: 0, y: 0 });
  return { x: sum.x / 4, y: sum.y / 4 };
}

// Of a convex quadrangle that goes clockwise on the screen.
function isInside(point, corners) {
  return corners.every((from, i) => {
    const to = corners[(i + 1) % 4];
    return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x) >= 0;
  });
}
