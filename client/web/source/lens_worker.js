// Watches pictures of the board and solves for the lens, in a worker, so that the page stays quick.
//
// In: {kind: "setup", width, height}, {kind: "frame", bitmap}, {kind: "solve"}. Out: {kind: "view",
// offer, views, coverage, seen, isEnough, corners}, {kind: "lens", camera, error, tilt}, or
// {kind: "refused", text}.
import { parseBoard } from "./lens/board.js";
import limits from "./lens/limits.json";
import { solveLens } from "./lens/solve.js";
import { Views } from "./lens/views.js";
import { Detector } from "./markers/detector.js";
import { GreyImage } from "./markers/grey_image.js";
import table from "./markers/opencv.json";

let setup = null;

function prepare({ width, height }) {
  const board = parseBoard(limits.board);
  const canvas = new OffscreenCanvas(width, height);
  setup = {
    width,
    height,
    views: new Views(board, width, height),
    detector: new Detector(table, limits.dictionary, width, height, [...board.markers.keys()]),
    grey: new GreyImage(width, height),
    context: canvas.getContext("2d", { willReadFrequently: true, alpha: false }),
  };
}

function look({ bitmap }) {
  const { width, height, views, detector, grey, context } = setup;
  context.drawImage(bitmap, 0, 0, width, height);
  bitmap.close();
  grey.setFromRgba(context.getImageData(0, 0, width, height).data);
  const markers = detector.detect(grey);
  const offer = views.offer(markers);
  const { coverage, seen, isEnough } = views;
  const corners = markers.map(({ id, corners: points }) => ({
    marker: id,
    pixels: points.flatMap(({ x, y }) => [x, y]),
  }));
  self.postMessage({
    kind: "view",
    offer,
    views: views.taken.length,
    coverage,
    seen,
    isEnough,
    corners,
  });
}

function solve() {
  try {
    self.postMessage({ kind: "lens", ...solveLens(setup.views, setup.width, setup.height) });
  } catch (error) {
    self.postMessage({ kind: "refused", text: error.message });
  }
}

const steps = { setup: prepare, frame: look, solve };
self.onmessage = ({ data }) => steps[data.kind](data);
