// The pinhole camera with OpenCV's lens distortion, and how its pixels move with its parameters.
// Parameters of a lens: fx, fy, cx, cy, k1, k2, p1, p2.

export const LENS_SIZE = 8;
export const POSE_SIZE = 6;

/** @typedef {{rotation: number[][], translation: number[]}} Pose camera_from_board */

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @returns {number[]} a point of the board's plane in the camera's frame */
export function moved({ rotation, translation }, [x, y]) {
  return rotation.map((row, i) => row[0] * x + row[1] * y + translation[i]);
}

/**
 * @param {number[]} lens
 * @param {number[]} point in front of the camera: x right, y down, z forward
 * @returns {number[]} pixel
 */
export function project(lens, [px, py, pz]) {
  const [fx, fy, cx, cy, k1, k2, p1, p2] = lens;
  const [x, y] = [px / pz, py / pz];
  const r2 = x * x + y * y;
  const radial = 1 + k1 * r2 + k2 * r2 * r2;
  return [
    fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + cx,
    fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + cy,
  ];
}

/**
 * Derivatives of project(lens, moved(pose, point)).
 * @returns {number[][]} a row for x and one for y: by the lens's parameters, then by a small
 *   rotation about the camera's axes, radians, that is applied after the pose's, and by its
 *   translation
 */
export function derivatives(lens, pose, point) {
  const [fx, fy, , , k1, k2, p1, p2] = lens;
  const at = moved(pose, point);
  const z = at[2];
  const [x, y] = [at[0] / z, at[1] / z];
  const r2 = x * x + y * y;
  const radial = 1 + k1 * r2 + k2 * r2 * r2;
  const slope = 2 * (k1 + 2 * k2 * r2); // of the radial factor, by x / x and by y / y
  const u = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
  const v = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  const both = slope * x * y + 2 * p1 * x + 2 * p2 * y; // u by y, and v by x
  const ux = radial + slope * x * x + 2 * p1 * y + 6 * p2 * x;
  const vy = radial + slope * y * y + 6 * p1 * y + 2 * p2 * x;
  const byPoint = [
    [ux / z, both / z, -(ux * x + both * y) / z].map((value) => fx * value),
    [both / z, vy / z, -(both * x + vy * y) / z].map((value) => fy * value),
  ];
  const turned = at.map((value, i) => value - pose.translation[i]);
  const byRotation = ([a, b, c]) => [
    // (w x turned), by w
    c * turned[1] - b * turned[2],
    a * turned[2] - c * turned[0],
    b * turned[0] - a * turned[1],
  ];
  const rest = byPoint.map((row) => [...byRotation(row), ...row]);
  return [
    [u, 0, 1, 0, fx * x * r2, fx * x * r2 * r2, 2 * fx * x * y, fx * (r2 + 2 * x * x), ...rest[0]],
    [0, v, 0, 1, fy * y * r2, fy * y * r2 * r2, fy * (r2 + 2 * y * y), 2 * fy * x * y, ...rest[1]],
  ];
}

/** @returns {number[][]} the rotation by a vector's length about its direction [Rodrigues] */
export function rotationBy(vector) {
  const angle = Math.hypot(...vector);
  if (angle < 1e-12) {
    return [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
  }
  const [x, y, z] = vector.map((value) => value / angle);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const k = 1 - c;
  return [
    [c + x * x * k, x * y * k - z * s, x * z * k + y * s],
    [y * x * k + z * s, c + y * y * k, y * z * k - x * s],
    [z * x * k - y * s, z * y * k + x * s, c + z * z * k],
  ];
}

/** @returns {number[][]} a b */
export function product(a, b) {
  const columns = [0, 1, 2].map((j) => b.map((row) => row[j]));
  return a.map((row) => columns.map((column) => dot(row, column)));
}
