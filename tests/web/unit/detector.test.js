// Markers drawn by their formula, and photographs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import jpeg from "jpeg-js";
import { Dictionary } from "amalgam-page/markers/dictionary.js";
import { Detector } from "amalgam-page/markers/detector.js";
import { GreyImage } from "amalgam-page/markers/grey_image.js";
import { readPattern } from "amalgam-page/markers/pattern.js";
import table from "amalgam-page/markers/opencv.json";
import { drawMarker, patternOf } from "../support/drawn_marker.js";
import { testData } from "../support/places.js";

const MARKER_40 = patternOf("DICT_6X6_250", 40);

const furthest = (found, expected) =>
  Math.max(...found.map(({ x, y }, i) => Math.hypot(x - expected[i].x, y - expected[i].y)));

const SQUARE = [
  [50.3, 40.7],
  [110.3, 42.2],
  [107.9, 101.4],
  [48.1, 99.8],
].map(([x, y]) => ({ x, y }));

test("corners are those of the print, top left first, however it is turned", () => {
  for (let quarters = 0; quarters < 4; ++quarters) {
    const corners = SQUARE.map((_, i) => SQUARE[(i + quarters) % 4]);
    const image = drawMarker(MARKER_40, corners, 160, 140);
    const found = new Detector(table, "DICT_6X6_250", 160, 140).detect(image);
    assert.deepEqual(
      found.map(({ id }) => id),
      [40],
    );
    // Measured: 0.03 px. A pixel's corner taken for its centre would be 0.7 px.
    assert.ok(
      furthest(found[0].corners, corners) < 0.1,
      `${furthest(found[0].corners, corners)} px`,
    );
  }
});

test("markers are found in perspective and when they are small", () => {
  const cases = [
    [
      [20, 30],
      [130, 44],
      [112, 92],
      [8, 110],
    ],
    [
      [60.5, 50.2],
      [84.6, 51.1],
      [83.2, 74.9],
      [59.8, 74.1],
    ],
  ];
  for (const points of cases) {
    const corners = points.map(([x, y]) => ({ x, y }));
    const image = drawMarker(MARKER_40, corners, 160, 140);
    const found = new Detector(table, "DICT_6X6_250", 160, 140, [40]).detect(image);
    assert.equal(found.length, 1);
    assert.ok(
      furthest(found[0].corners, corners) < 0.2,
      `${furthest(found[0].corners, corners)} px`,
    );
  }
});

test("a first look at half the size moves no corner", () => {
  // Large ones are found by it, and small ones without it.
  for (const side of [30, 37, 45.3, 70, 131.7]) {
    const turned = [
      [0, 0.1],
      [0.95, 0],
      [1, 0.9],
      [0.08, 1],
    ].map(([u, v]) => ({ x: 12.3 + side * u, y: 9.6 + side * v }));
    const image = drawMarker(MARKER_40, turned, 160, 160);
    const detector = new Detector(table, "DICT_6X6_250", 160, 160, [40]);
    const all = new Detector(table, "DICT_6X6_250", 160, 160);
    // Often, because looks that find nothing are given up.
    for (let i = 0; i < 12; ++i) {
      const found = detector.detect(image);
      assert.equal(found.length, 1);
      const [same] = all.detect(image);
      assert.ok(furthest(found[0].corners, same.corners) < 0.02);
      assert.ok(furthest(found[0].corners, turned) < 0.2);
    }
  }
});

test("markers of which only some are large are all found, once", () => {
  const square = (left, top, side) =>
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ].map(([u, v]) => ({ x: left + side * u, y: top + side * v }));
  const large = drawMarker(MARKER_40, square(20, 20, 80), 200, 140);
  const small = drawMarker(patternOf("DICT_6X6_250", 7), square(130, 60, 26), 200, 140);
  small.data.forEach((value, i) => (large.data[i] = Math.min(large.data[i], value)));
  const detector = new Detector(table, "DICT_6X6_250", 200, 140, [7, 40]);
  for (let i = 0; i < 12; ++i) {
    const ids = detector.detect(large).map(({ id }) => id);
    assert.deepEqual(ids.sort((a, b) => a - b), [7, 40]);
  }
});

test("others' markers are not reported", () => {
  const image = drawMarker(MARKER_40, SQUARE, 160, 140);
  assert.deepEqual(new Detector(table, "DICT_6X6_250", 160, 140, [7]).detect(image), []);
});

test("an even picture and a black square hold no marker", () => {
  const grey = new GreyImage(160, 140, new Uint8Array(160 * 140).fill(128));
  assert.deepEqual(new Detector(table, "DICT_6X6_250", 160, 140).detect(grey), []);
  const black = drawMarker(Array(6).fill("000000"), SQUARE, 160, 140);
  assert.deepEqual(new Detector(table, "DICT_6X6_250", 160, 140).detect(black), []);
});

test("a pattern without a black border is none", () => {
  // Marker 40 with a white border inside of a black one, ten bits wide in all.
  const white = "11111111";
  const framed = [white, ...MARKER_40.map((row) => `1${row}1`), white];
  const square = (from, to) =>
    [
      [from, from],
      [to, from],
      [to, to],
      [from, to],
    ].map(([x, y]) => ({ x, y }));
  const image = drawMarker(framed, square(10, 110), 120, 120);
  assert.equal(readPattern(image, square(20, 100), 6), null);
});

test("wrong bits are corrected as far as OpenCV does, and no further", () => {
  const dictionary = new Dictionary(table, "DICT_6X6_250"); // 5 bits, times 0.6
  const code = BigInt(`0b${MARKER_40.join("")}`);
  assert.deepEqual(dictionary.find(code), { id: 40, quarters: 0 });
  const three = code ^ 0b100000000100000000100n;
  assert.equal(dictionary.find(three)?.id, 40);
  assert.equal(dictionary.find(three ^ 1n), null);
});

test("each family of dictionaries is read", () => {
  for (const [name, id] of [
    ["DICT_4X4_50", 7],
    ["DICT_5X5_100", 33],
    ["DICT_7X7_250", 101],
    ["DICT_APRILTAG_36h11", 9],
  ]) {
    const image = drawMarker(patternOf(name, id), SQUARE, 160, 140);
    const found = new Detector(table, name, 160, 140).detect(image);
    assert.deepEqual(
      found.map((marker) => marker.id),
      [id],
      name,
    );
  }
});

const data = testData();
const skip = data ? false : "the photographs are not there";

/** Calls back for each photograph of the dictionary, with the known markers and those found. */
function forPhotographs(wanted, callback) {
  const folder = join(data, "real_markers");
  for (const entry of JSON.parse(readFileSync(join(folder, "expected_public.json")))) {
    if (entry.dictionary !== wanted) continue;
    const { width, height, data: rgba } = jpeg.decode(readFileSync(join(folder, entry.image)));
    const grey = new GreyImage(width, height);
    grey.setFromRgba(rgba);
    const found = new Detector(table, wanted, width, height).detect(grey);
    const known = entry.markers.map(({ id, corners }) => ({
      id,
      corners: corners.map(([x, y]) => ({ x, y })),
    }));
    callback(entry.image, known, found);
  }
}

test("every marker of the desk photographs is found, and nothing else", { skip }, () => {
  let photographs = 0;
  forPhotographs("DICT_6X6_250", (image, known, found) => {
    ++photographs;
    assert.equal(found.length, known.length, image);
    for (const { id, corners } of known) {
      const marker = found.find((other) => other.id === id);
      assert.ok(marker, `${image}, marker ${id}`);
      // What is known are OpenCV's unrefined corners: whole pixels, on the inside of the edge.
      const error = furthest(marker.corners, corners);
      assert.ok(error < 2, `${image}, marker ${id}: ${error} px`);
    }
  });
  assert.equal(photographs, 2);
});

test("of tags in a field, more are found than by the native client", { skip }, () => {
  const shares = [];
  forPhotographs("DICT_APRILTAG_36h11", (image, known, found) => {
    // Corners are in another order there.
    const isKnown = (marker) =>
      known.some(({ id, corners }) => {
        const [a, b] = [marker.corners, corners].map(centre);
        return id === marker.id && Math.hypot(a.x - b.x, a.y - b.y) < 3;
      });
    shares.push(found.filter(isKnown).length);
  });
  // The native client: 11, 4 and 7, of 12, 25 and 10.
  const atLeast = [11, 12, 8];
  shares.forEach((count, i) =>
    assert.ok(count >= atLeast[i], `photograph ${i}: ${count} of ${shares}`),
  );
});

function centre(corners) {
  const sum = (of) => corners.reduce((total, corner) => total + corner[of], 0) / 4;
  return { x: sum("x"), y: sum("y") };
}
