// Views of a board that a known lens gives: the lens must come back, and sets that do not determine
// it must be refused.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { parseCalibration } from "amalgam-page/calibration.js";
import { parseBoard } from "amalgam-page/lens/board.js";
import { firstGuess } from "amalgam-page/lens/first_guess.js";
import limits from "amalgam-page/lens/limits.json";
import { toYaml } from "amalgam-page/lens/opencv_yaml.js";
import { derivatives, moved, project, rotationBy } from "amalgam-page/lens/projection.js";
import { solveLens } from "amalgam-page/lens/solve.js";
import { Views } from "amalgam-page/lens/views.js";
import { boardView, goodHolds, randomNumbers } from "../support/held_board.js";
import { sourceFile } from "../support/places.js";

const [WIDTH, HEIGHT] = [640, 480];
const LENS = [502, 507, 325.5, 235.5, -0.12, 0.05, 0.001, 0];
const CAMERA = { width: WIDTH, height: HEIGHT, lens: LENS };
const board = parseBoard(limits.board);

function viewsOf(holds, jitter) {
  const views = new Views(board, WIDTH, HEIGHT);
  for (const { tilt, position } of holds) {
    views.offer(boardView(CAMERA, board, tilt, position, jitter));
  }
  return views;
}

const near = (value, expected, within) =>
  assert.ok(Math.abs(value - expected) <= within, `${value} for ${expected}`);

test("the board is the one that is printed", () => {
  assert.equal(board.markers.size, 17);
  assert.equal(board.black.length, 18);
  near(board.width, 0.16, 1e-12);
  near(board.height, 0.224, 1e-12);
  // The first one lies in the second square of the top row.
  const [topLeft, , bottomRight] = board.markers.get(0);
  near(topLeft.x, -0.08 + 0.032 + 0.004, 1e-12);
  near(topLeft.y, 0.112 - 0.004, 1e-12);
  near(topLeft.y - bottomRight.y, 0.024, 1e-12);
  assert.equal(board.markers.get(2).length, 4);
  near(board.markers.get(2)[0].x, -0.08 + 0.004, 1e-12);
});

test("derivatives are the differences of projections", () => {
  const pose = { rotation: rotationBy([0.3, -0.5, 0.2]), translation: [0.02, -0.03, 0.4] };
  const point = [0.06, -0.08];
  const step = 1e-6;
  const rows = derivatives(CAMERA.lens, pose, point);
  const at = (lens, turn, shift) => {
    const turned = moved({ ...pose, translation: [0, 0, 0] }, point);
    const r = rotationBy(turn);
    const back = r.map((row) => row[0] * turned[0] + row[1] * turned[1] + row[2] * turned[2]);
    return project(
      lens,
      back.map((value, i) => value + pose.translation[i] + shift[i]),
    );
  };
  for (let i = 0; i < 14; ++i) {
    const moveBy = (by) => {
      const all = [...CAMERA.lens, 0, 0, 0, 0, 0, 0];
      all[i] += by;
      return at(all.slice(0, 8), all.slice(8, 11), all.slice(11));
    };
    const [more, less] = [moveBy(step), moveBy(-step)];
    for (const axis of [0, 1]) {
      near(rows[axis][i], (more[axis] - less[axis]) / (2 * step), 1e-4);
    }
  }
});

test("without noise the lens comes back exactly", () => {
  const { camera, error } = solveLens(viewsOf(goodHolds()), WIDTH, HEIGHT);
  const { fx, fy, cx, cy, distortion } = camera;
  near(error, 0, 1e-6);
  [fx, fy, cx, cy, ...distortion].forEach((value, i) => near(value, CAMERA.lens[i], 1e-5));
});

test("with noise it comes back within what the noise allows", () => {
  const views = viewsOf(goodHolds(), { noise: 0.05, random: randomNumbers(7) });
  assert.ok(views.taken.length >= 15);
  assert.ok(views.coverage >= 0.9);
  const { camera, error, tilt } = solveLens(views, WIDTH, HEIGHT);
  // 0.05 pixels of noise, on two axes, of some thousand corners.
  near(error, 0.05 * Math.SQRT2, 0.01);
  near(camera.fx, CAMERA.lens[0], 0.002 * CAMERA.lens[0]);
  near(camera.fy, CAMERA.lens[1], 0.002 * CAMERA.lens[1]);
  near(camera.cx, CAMERA.lens[2], 1);
  near(camera.cy, CAMERA.lens[3], 1);
  near(camera.distortion[0], CAMERA.lens[4], 0.01);
  assert.ok(tilt > 30 && tilt < 90, `${tilt}`);
});

test("the closed form without distortion is near already", () => {
  const plain = { ...CAMERA, lens: [500, 500, 319.5, 239.5, 0, 0, 0, 0] };
  const views = new Views(board, WIDTH, HEIGHT);
  for (const { tilt, position } of goodHolds()) {
    views.offer(boardView(plain, board, tilt, position));
  }
  const { lens, poses } = firstGuess(views.taken, WIDTH, HEIGHT);
  near(lens[0], 500, 1e-3);
  near(lens[1], 500, 1e-3);
  near(poses[0].translation[2], 0.28, 1e-5);
});

test("lenses that see wide and narrow are found too", () => {
  for (const [fx, z] of [
    [330, 0.2],
    [1400, 0.85],
  ]) {
    const camera = { ...CAMERA, lens: [fx, fx, 320, 240, fx < 400 ? -0.2 : 0.02, 0.03, 0, 0] };
    const views = new Views(board, WIDTH, HEIGHT);
    for (const { tilt, position } of goodHolds()) {
      const [x, y, near] = position;
      views.offer(boardView(camera, board, tilt, [x, y, near - 0.3 + z]));
    }
    near(solveLens(views, WIDTH, HEIGHT).camera.fx, fx, 0.005 * fx);
  }
});

test("views like another are not taken", () => {
  const views = new Views(board, WIDTH, HEIGHT);
  const offer = (x) => views.offer(boardView(CAMERA, board, [0, 0, 0], [x, 0, 0.35]));
  assert.equal(offer(0), "taken");
  assert.equal(offer(0.002), "likeAnother");
  assert.equal(offer(0.03), "taken");
  assert.equal(views.offer([]), "fewMarkers");
  assert.equal(views.taken.length, 2);
  for (let i = 0; i < 200 && views.taken.length < limits.mostViews; ++i) {
    const tilt = [0.3 * Math.sin(i), 0.3 * Math.cos(2 * i), 0.7 * i];
    views.offer(boardView(CAMERA, board, tilt, [0.05 * Math.sin(3 * i), 0.03 * Math.cos(i), 0.35]));
  }
  assert.equal(views.taken.length, limits.mostViews);
  assert.ok(views.isEnough);
  assert.equal(offer(-0.09), "full");
});

test("covered cells are where the corners were", () => {
  const views = new Views(board, WIDTH, HEIGHT);
  views.offer(boardView(CAMERA, board, [0, 0, 0], [0.35, -0.25, 0.85]));
  const seen = views.seen.flatMap((isSeen, i) => (isSeen ? [[i % 5, Math.floor(i / 5)]] : []));
  assert.ok(seen.length >= 2);
  assert.ok(seen.every(([column, row]) => column >= 3 && row <= 1), JSON.stringify(seen));
});

test("sets that do not determine the lens are refused", () => {
  const refusal = (views) => {
    try {
      solveLens(views, WIDTH, HEIGHT);
      return "not refused";
    } catch (error) {
      return error.message;
    }
  };
  const few = viewsOf([{ tilt: [0, 0, 0], position: [0, 0, 0.35] }]);
  assert.match(refusal(few), /^1 different views/);

  const middle = Array.from({ length: 12 }, (_, i) => ({
    tilt: [0.3, 0, 1.1 * i],
    position: [0.04 * ((i % 3) - 1), 0.04 * (Math.floor(i / 3) - 1.5), 1],
  }));
  assert.match(refusal(viewsOf(middle)), /% of the picture/);

  // Without a tilt, focal length and distance cannot be told apart.
  const frontal = [-0.08, 0, 0.08].flatMap((x) =>
    [-0.06, 0, 0.06].map((y) => ({ tilt: [0, 0, 0], position: [x, y, 0.3] })),
  );
  assert.match(refusal(viewsOf(frontal)), /alike/);

  const blurred = viewsOf(goodHolds(), { noise: 3, random: randomNumbers(3) });
  assert.match(refusal(blurred), /contradict/);
});

test("the file is what the native client's test reads, and what the page reads", () => {
  const camera = {
    width: 640,
    height: 480,
    fx: 502.3456789012345,
    fy: 507.25,
    cx: 325.5,
    cy: 235.5,
    distortion: [-0.12, 0.05, 0.001, -1e-7],
  };
  const text = toYaml(camera, 0.25);
  assert.equal(text, readFileSync(sourceFile("tests/web/data/lens.yml"), "utf8"));
  assert.deepEqual(parseCalibration(text), { ...camera, distortion: [...camera.distortion, 0] });
});
