// Moves a found marker's corners to the intersections of its edges, to a few hundredths of a pixel.
// client/tracking/edge_refinement.h has the same method and says why: each of the four edges is
// measured along its length and fitted by a line.

const ITERATIONS = 3; // the first guess is off by up to a pixel
const MAX_REACH = 4; // pixels to either side of an edge; further is no edge's blur
const STEP = 0.5; // pixels between samples across an edge
const MIN_CONTRAST = 15; // grey levels across an edge, of 255
const MIN_POINTS = 4; // of an edge
const MAX_RESIDUAL = 0.5; // pixels from the first fit; beyond it is dirt, or an error of printing

const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

// The distance from the start at which brightness rises along the direction: the centre of mass of
// its increase. NaN if there is no edge.
function rise(grey, start, direction, reach) {
  let sum = 0;
  let moment = 0;
  let last = grey.at(start.x - reach * direction.x, start.y - reach * direction.y);
  for (let at = -reach + STEP; at <= reach; at += STEP) {
    const value = grey.at(start.x + at * direction.x, start.y + at * direction.y);
    const increase = Math.max(value - last, 0); // NaN stays NaN
    sum += increase;
    moment += increase * (at - STEP / 2);
    last = value;
  }
  return sum >= MIN_CONTRAST ? moment / sum : NaN;
}

// outward = offset + slope * along, by least squares; null if there are too few points.
function fit(points) {
  let sx = 0;
  let sy = 0;
  let sxx = 0;
  let sxy = 0;
  for (const { along, outward } of points) {
    sx += along;
    sy += outward;
    sxx += along * along;
    sxy += along * outward;
  }
  const n = points.length;
  const determinant = n * sxx - sx * sx;
  if (n < MIN_POINTS || !(determinant > 1e-9)) return null;
  const slope = (n * sxy - sx * sy) / determinant;
  return { offset: (sy - slope * sx) / n, slope };
}

function measureEdge(grey, from, to, reach) {
  const length = distance(from, to);
  const direction = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
  const outward = { x: direction.y, y: -direction.x }; // corners go clockwise on the screen
  let points = [];
  // Not near the ends, where the neighbouring edge's blur bends this one's.
  for (let along = reach; along <= length - reach; along += 1) {
    const start = { x: from.x + along * direction.x, y: from.y + along * direction.y };
    const at = rise(grey, start, outward, reach);
    if (!Number.isNaN(at)) points.push({ along, outward: at });
  }
  let line = fit(points);
  if (!line) return null;
  const near = ({ along, outward: at }) =>
    Math.abs(at - line.offset - line.slope * along) <= MAX_RESIDUAL;
  points = points.filter(near);
  line = fit(points);
  if (!line) return null;
  return {
    point: { x: from.x + line.offset * outward.x, y: from.y + line.offset * outward.y },
    direction: {
      x: direction.x + line.slope * outward.x,
      y: direction.y + line.slope * outward.y,
    },
  };
}

function intersection(a, b) {
  const cross = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
  if (Math.abs(cross) < 1e-3) return null;
  const between = { x: b.point.x - a.point.x, y: b.point.y - a.point.y };
  const t = (between.x * b.direction.y - between.y * b.direction.x) / cross;
  return { x: a.point.x + t * a.direction.x, y: a.point.y + t * a.direction.y };
}

/**
 * @param {GreyImage} grey
 * @param {number} bits of the marker's pattern along a side, without its border of one bit
 * @param {{x: number, y: number}[]} corners clockwise on the screen
 * @returns {{x: number, y: number}[]} corners that cannot be improved (weak edges, or a result
 *   further than half a bit away) are unchanged
 */
export function refineCorners(grey, bits, corners) {
  let refined = corners;
  for (let iteration = 0; iteration < ITERATIONS; ++iteration) {
    const edges = refined.map((from, i) => {
      const to = refined[(i + 1) % 4];
      // The bit across an edge is foreshortened as its neighbouring sides are.
      const before = distance(refined[(i + 3) % 4], from);
      const bit = Math.min(before, distance(to, refined[(i + 2) % 4])) / (bits + 2);
      const reach = Math.min(Math.max(0.6 * bit, 1), MAX_REACH);
      return { bit, line: measureEdge(grey, from, to, reach) };
    });
    refined = refined.map((corner, i) => {
      const before = edges[(i + 3) % 4];
      const after = edges[i];
      if (!before.line || !after.line) return corner;
      const found = intersection(before.line, after.line);
      const furthest = Math.max(1.5, Math.max(after.bit, before.bit) / 2);
      return found && distance(found, corners[i]) <= furthest ? found : corner;
    });
  }
  return refined;
}
