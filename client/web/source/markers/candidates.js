// Quadrangles in an image that may be markers: dark areas, after an adaptive threshold, whose
// outline is a convex quadrangle. Thresholds, outlines and polygons are js-aruco2's.
import aruco from "js-aruco2/src/cv.js";

const { CV } = aruco;

// Radii of the threshold's window in pixels, as OpenCV's windows of 3 to 23. A small one keeps
// small markers apart from what is near them; a large one sees through a blurred edge. The middle
// one, which finds most, comes first: who has found all that he looks for needs no other.
export const RADII = [6, 2, 11];
const THRESHOLD = 7; // grey levels below the mean of its window: dark
// Shares of the image's larger side.
const MIN_PERIMETER = 0.03;
const MAX_PERIMETER = 4;
const POLYGON_ERROR = 0.03; // of the outline's length
const MIN_SIDE = 0.05; // of the outline's length, so that narrow strips are left out

export class CandidateSearch {
  #binary;
  #bordered;

  constructor(width, height) {
    this.#binary = new CV.Image(width, height, new Uint8Array(width * height));
    // Outlines are numbered, with their sign, so that bytes are not enough.
    this.#bordered = new Int32Array((width + 2) * (height + 2));
  }

  /**
   * @param {GreyImage} grey of the size given to the constructor
   * @param {number} radius one of RADII
   * @returns {{x: number, y: number}[][]} four whole pixels each, clockwise on the screen, the
   *   outermost dark ones; larger ones come first
   */
  find(grey, radius) {
    CV.adaptiveThreshold(grey, this.#binary, radius, THRESHOLD);
    const larger = Math.max(grey.width, grey.height);
    const found = [];
    for (const outline of CV.findContours(this.#binary, this.#bordered)) {
      if (outline.length < MIN_PERIMETER * larger || outline.length > MAX_PERIMETER * larger)
        continue;
      const corners = CV.approxPolyDP(outline, outline.length * POLYGON_ERROR);
      if (corners.length !== 4 || !CV.isContourConvex(corners)) continue;
      if (CV.minEdgeLength(corners) < MIN_SIDE * outline.length) continue;
      found.push({ corners: clockwise(corners), perimeter: outline.length });
    }
    return found.sort((a, b) => b.perimeter - a.perimeter).map(({ corners: c }) => c);
  }
}

function clockwise(corners) {
  const [a, b, c, d] = corners;
  const cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return cross < 0 ? [a, d, c, b] : [a, b, c, d];
}
