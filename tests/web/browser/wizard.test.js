// The page measures the lens of a camera that films the board.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { parseCalibration } from "amalgam-page/calibration.js";
import { parseBoard } from "amalgam-page/lens/board.js";
import limits from "amalgam-page/lens/limits.json";
import { CHROMIUM, closeBrowsers, openPage, startCamera, textMatches } from "../support/browser.js";
import { drawBoard } from "../support/drawn_board.js";
import { colored, writeFilm } from "../support/film.js";
import { goodHolds } from "../support/held_board.js";
import { buildFolder } from "../support/places.js";
import { StubServer, unchanged, WELCOME } from "../support/stub_server.js";

const skip = existsSync(CHROMIUM) ? false : "there is no Chromium";
const PAGE = join(buildFolder(), "web");
const CAMERA = { width: 640, height: 480, focal: 500 };
const FRAMES_EACH = 3; // a browser that is busy misses single frames

let folder;
const film = (name) => join(folder, `${name}.y4m`);
const board = parseBoard(limits.board);

before(() => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), "amalgam-board-"));
  const holds = [
    ...goodHolds(),
    { tilt: [0.5, 0, 0], position: [0.02, 0, 0.4] },
    { tilt: [-0.5, 0, 0.4], position: [-0.02, 0.03, 0.4] },
    { tilt: [0, 0.5, -0.4], position: [0.04, -0.03, 0.4] },
    { tilt: [0, -0.5, 1.5], position: [-0.05, 0, 0.4] },
  ];
  const views = holds.map((hold) => colored(drawBoard(CAMERA, board, limits.dictionary, hold)));
  writeFilm(
    film("held"),
    views.flatMap((view) => Array(FRAMES_EACH).fill(view)),
  );
  writeFilm(film("still"), [views[0]]);
});
after(async () => {
  await closeBrowsers();
  if (folder) rmSync(folder, { recursive: true });
});

const answers = {
  hello: (_, send) => send("welcome", WELCOME),
  cameraFrame: (frame, send) => send("composite", { ...unchanged(frame), poses: [] }),
};
const hellos = (server) => server.received.filter(({ kind }) => kind === "hello");
const openWizard = async (page) => {
  await page.keyboard.press("p");
  await page.getByRole("button", { name: "Measure the lens" }).click();
};

test("the lens is measured, used, saved and remembered", { skip }, async () => {
  const server = new StubServer(PAGE, answers);
  const address = await server.listen();
  const { page, complaints, close } = await openPage({ film: film("held") });
  try {
    await startCamera(page, address);
    await textMatches(page, "#chip", /^connected/);
    await openWizard(page);
    await textMatches(page, "#wizard-state", /The lens is/, 30000);
    assert.ok(await page.isHidden("#controls"));
    assert.ok((await page.locator("#coverage .seen").count()) >= 23);

    const saved = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save as file" }).click();
    const download = await saved;
    assert.equal(download.suggestedFilename(), "lens-640x480.yml");
    const camera = parseCalibration(readFileSync(await download.path(), "utf8"));
    const within = (value, expected, most) =>
      assert.ok(Math.abs(value - expected) < most, `${value} for ${expected}`);
    within(camera.fx, CAMERA.focal, 0.005 * CAMERA.focal);
    within(camera.fy, CAMERA.focal, 0.005 * CAMERA.focal);
    within(camera.cx, 319.5, 3);
    within(camera.cy, 239.5, 3);
    within(camera.distortion[0], 0, 0.02);

    await page.getByRole("button", { name: "Use this lens" }).click();
    await textMatches(page, "#chip", /^connected/);
    assert.equal(hellos(server).at(-1).value.camera.fx, camera.fx);
    await page.keyboard.press("p");
    await textMatches(page, "#lens-state", /Measured for this camera and size: 65\.\d° wide/);
    assert.ok(await page.isDisabled("#fov"));

    await page.reload();
    await startCamera(page, address);
    await textMatches(page, "#chip", /^connected/);
    assert.equal(hellos(server).at(-1).value.camera.fx, camera.fx);
    await page.keyboard.press("p");
    await page.getByRole("button", { name: "Forget the measured lens" }).click();
    await textMatches(page, "#chip", /^connected/);
    assert.ok(Math.abs(hellos(server).at(-1).value.camera.fx - 320 * Math.sqrt(3)) < 1e-9);
    assert.deepEqual(complaints, []);
  } finally {
    await close();
    await server.close();
  }
});

test("a board that is held still is one view, and the camera goes back", { skip }, async () => {
  const server = new StubServer(PAGE, answers);
  const address = await server.listen();
  const { page, close } = await openPage({ film: film("still") });
  try {
    await page.goto(address);
    await openWizard(page); // which starts the camera
    await textMatches(page, "#wizard-state", /1 views.*Turn or move the board.*At least 7 more/);
    assert.ok(await page.isDisabled("#wizard-finish"));
    await page.getByRole("button", { name: "Close" }).click();
    assert.ok(await page.isHidden("#wizard"));
    await textMatches(page, "#summary", /fps/);
  } finally {
    await close();
    await server.close();
  }
});

test("the board on a screen is the one that is looked for", { skip }, async () => {
  const server = new StubServer(PAGE, answers);
  const address = await server.listen();
  const { page, complaints, close } = await openPage({
    page: { viewport: { width: 900, height: 700 } },
  });
  try {
    await page.goto(`${address}board.html`);
    await page.waitForFunction(() => document.getElementById("board").width === 900);
    const png = await page.screenshot();
    // As a camera that faces the screen sees it, turned by a quarter.
    const corners = await page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const worker = new Worker("lens_worker.js", { type: "module" });
      const answer = new Promise((resolve) => (worker.onmessage = ({ data }) => resolve(data)));
      worker.postMessage({ kind: "setup", width: bitmap.width, height: bitmap.height });
      worker.postMessage({ kind: "frame", bitmap }, [bitmap]);
      return (await answer).corners;
    }, png.toString("base64"));
    assert.equal(corners.length, board.markers.size);
    const margin = board.black[0].side / 2; // a quarter of a square on each side
    const scale = Math.min(900 / (board.height + margin), 700 / (board.width + margin));
    for (const { marker, pixels } of corners) {
      board.markers.get(marker).forEach(({ x, y }, i) => {
        // A quarter clockwise: the board's right goes down, and its top goes right.
        const expected = [450 + scale * y - 0.5, 350 + scale * x - 0.5];
        const distance = Math.hypot(pixels[2 * i] - expected[0], pixels[2 * i + 1] - expected[1]);
        assert.ok(distance < 0.15, `${distance} pixels`);
      });
    }
    assert.deepEqual(complaints, []);
  } finally {
    await close();
    await server.close();
  }
});
