// A lens without distortion and the poses of the board, in closed form, from which the refinement
// starts [Z. Zhang, A Flexible New Technique for Camera Calibration, 2000]. The principal point is
// taken for the middle of the picture, as OpenCV does: the closed form finds it badly.
import {
  EigenvalueDecomposition,
  inverse,
  Matrix,
  SingularValueDecomposition,
  solve,
} from "ml-matrix";

const column = (matrix, j) => matrix.getColumn(j);
const scaled = (vector, by) => vector.map((value) => value * by);
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (vector) => scaled(vector, 1 / Math.hypot(...vector));

// Moves points to their mean and to a distance of about 1 [R. Hartley, In Defense of the
// Eight-Point Algorithm, 1997].
function normalising(points) {
  const mean = [0, 1].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
  const distance = points.reduce((sum, p) => sum + Math.hypot(p[0] - mean[0], p[1] - mean[1]), 0);
  const s = points.length / distance;
  return new Matrix([
    [s, 0, -s * mean[0]],
    [0, s, -s * mean[1]],
    [0, 0, 1],
  ]);
}

/**
 * @param {Point[]} view
 * @returns {Matrix} the projective map from the board's plane to pixels
 */
export function homography(view) {
  const toBoard = normalising(view.map(({ board }) => board));
  const toPixels = normalising(view.map(({ pixel }) => pixel));
  const apply = (m, [x, y]) => [m.get(0, 0) * x + m.get(0, 2), m.get(1, 1) * y + m.get(1, 2)];
  const rows = view.flatMap(({ board, pixel }) => {
    const [x, y] = apply(toBoard, board);
    const [u, v] = apply(toPixels, pixel);
    return [
      [x, y, 1, 0, 0, 0, -u * x, -u * y, -u],
      [0, 0, 0, x, y, 1, -v * x, -v * y, -v],
    ];
  });
  const a = new Matrix(rows);
  // The least squares solution of length 1: the eigenvector of the smallest eigenvalue.
  const eigen = new EigenvalueDecomposition(a.transpose().mmul(a), { assumeSymmetric: true });
  const values = eigen.realEigenvalues;
  const h = column(eigen.eigenvectorMatrix, values.indexOf(Math.min(...values)));
  const normalised = new Matrix([h.slice(0, 3), h.slice(3, 6), h.slice(6, 9)]);
  return inverse(toPixels).mmul(normalised).mmul(toBoard);
}

// 1 / fx^2 and 1 / fy^2 solve two linear equations of each view: the images of the board's axes,
// and those of its diagonals, are orthogonal.
function focalLengths(homographies, cx, cy) {
  const equations = [];
  const right = [];
  for (const h of homographies) {
    const centred = new Matrix([
      [1, 0, -cx],
      [0, 1, -cy],
      [0, 0, 1],
    ]).mmul(h);
    const [a, b] = [column(centred, 0), column(centred, 1)];
    const sum = a.map((value, i) => value + b[i]);
    const difference = a.map((value, i) => value - b[i]);
    for (const [p, q] of [
      [unit(a), unit(b)],
      [unit(sum), unit(difference)],
    ]) {
      equations.push([p[0] * q[0], p[1] * q[1]]);
      right.push([-p[2] * q[2]]);
    }
  }
  const found = solve(new Matrix(equations), new Matrix(right), true).to1DArray();
  return found.map((value) => 1 / Math.sqrt(Math.abs(value)));
}

/** @returns {Pose} */
function poseOf(h, lens) {
  const [fx, fy, cx, cy] = lens;
  const k = new Matrix([
    [fx, 0, cx],
    [0, fy, cy],
    [0, 0, 1],
  ]);
  const axes = inverse(k).mmul(h);
  const [a, b, t] = [column(axes, 0), column(axes, 1), column(axes, 2)];
  // The board lies in front of the camera.
  const scale = (Math.sign(t[2]) || 1) / Math.sqrt(Math.hypot(...a) * Math.hypot(...b));
  const [x, y] = [scaled(a, scale), scaled(b, scale)];
  const near = new Matrix([x, y, cross(x, y)]).transpose();
  // The rotation nearest to it.
  const svd = new SingularValueDecomposition(near);
  const rotation = svd.leftSingularVectors.mmul(svd.rightSingularVectors.transpose());
  return { rotation: rotation.to2DArray(), translation: scaled(t, scale) };
}

/**
 * @param {Point[][]} views
 * @returns {{lens: number[], poses: Pose[]}} as in projection.js
 */
export function firstGuess(views, width, height) {
  const [cx, cy] = [(width - 1) / 2, (height - 1) / 2];
  const homographies = views.map(homography);
  // Views without any tilt say nothing about it; whoever refuses them needs some lens all the same.
  const usable = (value) => Number.isFinite(value) && value > 0.1 * width && value < 20 * width;
  const found = focalLengths(homographies, cx, cy);
  const [fx, fy] = found.every(usable) ? found : [width, width];
  const lens = [fx, fy, cx, cy, 0, 0, 0, 0];
  return { lens, poses: homographies.map((h) => poseOf(h, lens)) };
}
