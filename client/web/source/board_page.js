// The board on a screen, in place of paper: as large as the window, and turned if that is larger.
// Its size does not matter to a lens.
import { parseBoard } from "./lens/board.js";
import limits from "./lens/limits.json";
import { patternRows } from "./markers/dictionary.js";
import table from "./markers/opencv.json";

const MARGIN = 0.25; // of a square, white around the board

const canvas = document.getElementById("board");
const board = parseBoard(limits.board);

function drawMarker(context, id, [corner, next]) {
  const rows = patternRows(table, limits.dictionary, id);
  const cell = (next.x - corner.x) / (rows.length + 2);
  context.fillStyle = "#000000";
  context.fillRect(corner.x, -corner.y, next.x - corner.x, next.x - corner.x);
  context.fillStyle = "#ffffff";
  rows.forEach((row, y) => {
    // Whole runs of white cells, so that no seams show between them.
    for (const run of row.matchAll(/1+/g)) {
      const left = corner.x + (run.index + 1) * cell;
      context.fillRect(left, -corner.y + (y + 1) * cell, run[0].length * cell, cell);
    }
  });
}

function draw() {
  const { clientWidth, clientHeight } = document.documentElement;
  canvas.width = Math.round(clientWidth * devicePixelRatio);
  canvas.height = Math.round(clientHeight * devicePixelRatio);
  const context = canvas.getContext("2d", { alpha: false });
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  const turn = canvas.width > canvas.height;
  const [across, down] = turn ? [board.height, board.width] : [board.width, board.height];
  const margin = 2 * MARGIN * board.black[0].side;
  const scale = Math.min(canvas.width / (across + margin), canvas.height / (down + margin));
  context.translate(canvas.width / 2, canvas.height / 2);
  if (turn) context.rotate(Math.PI / 2);
  context.scale(scale, scale);
  context.fillStyle = "#000000";
  for (const { x, y, side } of board.black) context.fillRect(x, -y, side, side);
  for (const [id, corners] of board.markers) drawMarker(context, id, corners);
}

addEventListener("resize", draw);
canvas.addEventListener("click", () => {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.();
});
draw();
