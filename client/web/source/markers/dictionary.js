// A dictionary of marker patterns: which marker a read pattern is, and how it is turned.
//
// A pattern is a BigInt of bits * bits bits, row by row from the top left, white is 1. opencv.json
// holds OpenCV's, and a test of the native client compares them.

const ERROR_CORRECTION_RATE = 0.6; // OpenCV's default

/** @returns {bigint} the pattern turned by a quarter, clockwise */
function turned(pattern, bits) {
  let result = 0n;
  for (let row = 0; row < bits; ++row) {
    for (let column = 0; column < bits; ++column) {
      // What comes to (row, column) was at (bits - 1 - column, row).
      const from = (bits - 1 - column) * bits + row;
      const bit = (pattern >> BigInt(bits * bits - 1 - from)) & 1n;
      result = (result << 1n) | bit;
    }
  }
  return result;
}

function popCount(value) {
  let count = 0;
  for (let rest = value; rest > 0; rest &= rest - 1) ++count;
  return count;
}

// BigInt arithmetic is slow: distances are counted on 30-bit pieces.
const PIECE = 30;

function pieces(pattern) {
  const list = [];
  for (let rest = pattern; list.length < 2 || rest > 0n; rest >>= BigInt(PIECE)) {
    list.push(Number(rest & 0x3fffffffn));
  }
  return list;
}

/** @returns {string[]} a marker's rows of "0" (black) and "1" (white), without the border */
export function patternRows(table, dictionary, id) {
  const { bits, codes } = table.dictionaries[dictionary];
  const code = BigInt(`0x${table.codes[codes].split(" ")[id]}`).toString(2);
  const all = code.padStart(bits * bits, "0");
  return Array.from({ length: bits }, (_, row) => all.slice(row * bits, (row + 1) * bits));
}

export class Dictionary {
  /** Bits along a side of the pattern, without the black border. */
  bits;
  #exact = new Map(); // pattern -> {id, quarters}
  #all = []; // {pieces, id, quarters}
  #correctable;

  /**
   * @param {object} table opencv.json
   * @param {string} name OpenCV's, as "DICT_6X6_250"; an Error says if it is unknown
   */
  constructor(table, name) {
    const entry = table.dictionaries[name];
    if (!entry) throw new Error(`This page does not know the marker dictionary “${name}”.`);
    this.bits = entry.bits;
    this.#correctable = Math.floor(entry.correct * ERROR_CORRECTION_RATE);
    const codes = table.codes[entry.codes].split(" ").slice(0, entry.count);
    codes.forEach((code, id) => {
      let pattern = BigInt(`0x${code}`);
      for (let quarters = 0; quarters < 4; ++quarters) {
        const match = { id, quarters };
        this.#exact.set(pattern, match);
        this.#all.push({ ...match, pieces: pieces(pattern) });
        pattern = turned(pattern, this.bits);
      }
    });
  }

  /**
   * @param {bigint} pattern as read from an image
   * @returns {{id: number, quarters: number} | null} quarters: how often the printed marker is
   *   turned clockwise by a quarter to get what was read
   */
  find(pattern) {
    const exact = this.#exact.get(pattern);
    if (exact) return exact;
    if (this.#correctable === 0) return null;
    const read = pieces(pattern);
    let best = null;
    let least = this.#correctable + 1;
    for (const candidate of this.#all) {
      let distance = 0;
      for (let i = 0; i < read.length; ++i) distance += popCount(read[i] ^ candidate.pieces[i]);
      if (distance < least) {
        least = distance;
        best = candidate;
      }
    }
    return best;
  }
}
