// The projective map from the unit square to a quadrangle.

/**
 * @param {{x: number, y: number}[]} corners where (0,0), (1,0), (1,1) and (0,1) go, convex
 * @returns {(u: number, v: number) => {x: number, y: number}}
 *
 * P. Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, section 2.2.3.
 */
export function squareToQuadrangle([a, b, c, d]) {
  const sx = a.x - b.x + c.x - d.x;
  const sy = a.y - b.y + c.y - d.y;
  const x1 = b.x - c.x;
  const x2 = d.x - c.x;
  const y1 = b.y - c.y;
  const y2 = d.y - c.y;
  const determinant = x1 * y2 - x2 * y1;
  const g = (sx * y2 - x2 * sy) / determinant;
  const h = (x1 * sy - sx * y1) / determinant;
  const xu = b.x - a.x + g * b.x;
  const xv = d.x - a.x + h * d.x;
  const yu = b.y - a.y + g * b.y;
  const yv = d.y - a.y + h * d.y;
  return (u, v) => {
    const w = g * u + h * v + 1;
    return { x: (xu * u + xv * v + a.x) / w, y: (yu * u + yv * v + a.y) / w };
  };
}
