// The board that a lens is measured with: a chessboard whose white squares hold markers. Metres, x
// right, y up, origin in the middle, as tracking/marker_board.h has it.

/**
 * @typedef {object} Board
 * @property {number} width
 * @property {number} height
 * @property {{x: number, y: number, side: number}[]} black squares, by their top left corners
 * @property {Map<number, {x: number, y: number}[]>} markers by their ids: the top left, top right,
 *   bottom right and bottom left corner
 */

/**
 * @param {string} text COLUMNSxROWS:SQUARE:MARKER, with the top left square black
 * @returns {Board}
 */
export function parseBoard(text) {
  const [sides, square, marker] = text.split(":");
  const [columns, rows] = sides.split("x").map(Number);
  const [pitch, side] = [Number(square), Number(marker)];
  const board = { width: columns * pitch, height: rows * pitch, black: [], markers: new Map() };
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const left = column * pitch - board.width / 2;
      const top = board.height / 2 - row * pitch;
      if ((row + column) % 2 === 0) {
        board.black.push({ x: left, y: top, side: pitch });
        continue;
      }
      const gap = (pitch - side) / 2;
      const [x, y] = [left + gap, top - gap];
      board.markers.set(board.markers.size, [
        { x, y },
        { x: x + side, y },
        { x: x + side, y: y - side },
        { x, y: y - side },
      ]);
    }
  }
  return board;
}
