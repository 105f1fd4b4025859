// The lens and the poses with the least squared distance between seen and projected corners
// [Levenberg 1944; Marquardt 1963]. A pose's corners know nothing of the other poses, so that poses
// are eliminated view by view and only the lens's parameters are solved for together [Triggs et
// al., Bundle Adjustment: A Modern Synthesis, 2000, section 6].
import { CholeskyDecomposition, Matrix } from "ml-matrix";
import {
  derivatives,
  LENS_SIZE,
  moved,
  POSE_SIZE,
  product,
  project,
  rotationBy,
} from "./projection.js";

const MOST_STEPS = 100;
const LEAST_GAIN = 1e-9; // of the sum of squares; what follows changes nothing that is seen
const MOST_DAMPING = 1e12;

const ALL = LENS_SIZE + POSE_SIZE;

/** @returns {number} sum of squared distances, pixels^2; infinite if a corner lies behind */
function sumOfSquares(views, { lens, poses }) {
  let sum = 0;
  views.forEach((view, i) => {
    for (const { board, pixel } of view) {
      const at = moved(poses[i], board);
      if (!(at[2] > 0)) sum = Infinity;
      const [x, y] = project(lens, at);
      sum += (x - pixel[0]) ** 2 + (y - pixel[1]) ** 2;
    }
  });
  return Number.isNaN(sum) ? Infinity : sum;
}

// J^T J and J^T r of one view, for the lens and its pose.
function normalEquations(view, lens, pose) {
  const jacobian = new Matrix(2 * view.length, ALL);
  const residual = new Matrix(2 * view.length, 1);
  view.forEach(({ board, pixel }, i) => {
    const projected = project(lens, moved(pose, board));
    derivatives(lens, pose, board).forEach((row, axis) => {
      jacobian.setRow(2 * i + axis, row);
      residual.set(2 * i + axis, 0, pixel[axis] - projected[axis]);
    });
  });
  const transposed = jacobian.transpose();
  return { matrix: transposed.mmul(jacobian), right: transposed.mmul(residual) };
}

function damped(matrix, damping) {
  const result = matrix.clone();
  for (let i = 0; i < matrix.rows; ++i) result.set(i, i, matrix.get(i, i) * (1 + damping));
  return result;
}

const part = (matrix, rows, columns) =>
  matrix.subMatrix(rows[0], rows[1] - 1, columns[0], columns[1] - 1);
const OF_LENS = [0, LENS_SIZE];
const OF_POSE = [LENS_SIZE, ALL];

// The step that the damped equations give; null if they have no solution.
function step(equations, damping) {
  let matrix = Matrix.zeros(LENS_SIZE, LENS_SIZE);
  let right = Matrix.zeros(LENS_SIZE, 1);
  const eliminated = [];
  for (const { matrix: all, right: r } of equations) {
    const own = new CholeskyDecomposition(damped(part(all, OF_POSE, OF_POSE), damping));
    if (!own.isPositiveDefinite()) return null;
    const mixed = part(all, OF_POSE, OF_LENS);
    const rightOfPose = part(r, OF_POSE, [0, 1]);
    const bound = own.solve(mixed);
    const free = own.solve(rightOfPose);
    const back = mixed.transpose();
    matrix.add(damped(part(all, OF_LENS, OF_LENS), damping)).sub(back.mmul(bound));
    right.add(part(r, OF_LENS, [0, 1])).sub(back.mmul(free));
    eliminated.push({ bound, free });
  }
  // Rounding makes it a little less than symmetric.
  const symmetric = Matrix.add(matrix, matrix.transpose()).mul(0.5);
  const whole = new CholeskyDecomposition(symmetric);
  if (!whole.isPositiveDefinite()) return null;
  const lens = whole.solve(right);
  return {
    lens: lens.to1DArray(),
    poses: eliminated.map(({ bound, free }) => Matrix.sub(free, bound.mmul(lens)).to1DArray()),
  };
}

function applied({ lens, poses }, change) {
  return {
    lens: lens.map((value, i) => value + change.lens[i]),
    poses: poses.map(({ rotation, translation }, i) => {
      const by = change.poses[i];
      return {
        rotation: product(rotationBy(by.slice(0, 3)), rotation),
        translation: translation.map((value, axis) => value + by[3 + axis]),
      };
    }),
  };
}

/**
 * @param {Point[][]} views
 * @param {{lens: number[], poses: Pose[]}} guess
 * @returns {{lens: number[], poses: Pose[], sum: number}} sum: of squared distances, pixels^2
 */
export function refine(views, guess) {
  let best = guess;
  let sum = sumOfSquares(views, best);
  let damping = 1e-3;
  for (let i = 0; i < MOST_STEPS && damping < MOST_DAMPING; ++i) {
    const equations = views.map((view, v) => normalEquations(view, best.lens, best.poses[v]));
    let gain = 0;
    while (gain <= 0 && damping < MOST_DAMPING) {
      const change = step(equations, damping);
      const next = change && applied(best, change);
      const nextSum = next ? sumOfSquares(views, next) : Infinity;
      gain = sum - nextSum;
      if (gain > 0) {
        best = next;
        damping = Math.max(damping / 10, 1e-12);
        if (gain <= LEAST_GAIN * sum) return { ...best, sum: nextSum };
        sum = nextSum;
      } else {
        damping *= 10;
      }
    }
  }
  return { ...best, sum };
}
