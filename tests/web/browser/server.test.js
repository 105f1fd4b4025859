// The page in a browser with a real server: its composites against the native client's.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import jpeg from "jpeg-js";
import { CHROMIUM, closeBrowsers, openPage, startCamera, textMatches } from "../support/browser.js";
import { writeFilm } from "../support/film.js";
import { deskPictures, nativeComposites, sceneFile, Server } from "../support/programs.js";

const skip = existsSync(CHROMIUM) ? false : "there is no Chromium";
const [WIDTH, HEIGHT] = [320, 240];
// Needs no OpenGL, and is quick on two cores.
const OPTIONS = { options: ["--renderer", "raytrace"] };
const SCENE = sceneFile("diffuse");

let folder;
let film;
let picture; // file
let camera; // its pixels, RGBA
let native; // the native client's composite of it, RGBA
let server;

const pixels = (bytes) => jpeg.decode(bytes, { useTArray: true }).data;

before(async () => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), "amalgam-desk-"));
  const [bytes] = await deskPictures(folder, `${WIDTH}x${HEIGHT}`, 1);
  picture = join(folder, "desk.jpg");
  film = join(folder, "desk.y4m");
  writeFileSync(picture, bytes);
  writeFilm(film, [jpeg.decode(bytes, { useTArray: true })]);
  camera = pixels(bytes);
  server = await Server.start(SCENE, OPTIONS);
  native = pixels(nativeComposites(server.address, ["--images", picture], 1)[0]);
});

after(async () => {
  await server?.stop();
  await closeBrowsers();
  if (folder) rmSync(folder, { recursive: true });
});

// As one string: a list of so many numbers would take seconds on its way.
const canvasPixels = async (page) => {
  const text = await page.evaluate(() => {
    const canvas = document.getElementById("canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return btoa(Array.from(data, (value) => String.fromCharCode(value)).join(""));
  });
  return new Uint8Array(Buffer.from(text, "base64"));
};

/** @returns {number[]} of each pixel, the largest difference of a channel */
function differences(a, b) {
  assert.equal(a.length, b.length);
  return Array.from({ length: a.length / 4 }, (_, i) =>
    Math.max(...[0, 1, 2].map((c) => Math.abs(a[4 * i + c] - b[4 * i + c]))),
  );
}

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const share = (values, above) => values.filter((value) => value > above).length / values.length;

test("the page shows what the native client gets for the same frame", { skip }, async () => {
  const { page, complaints, close } = await openPage({ film });
  try {
    await startCamera(page, `http://${server.web}/`);
    await textMatches(page, "#summary", /fps/);
    const shown = await canvasPixels(page);
    // That there is something to see: the objects and their shadows.
    assert.ok(share(differences(native, camera), 40) > 0.02);
    const error = differences(shown, native);
    // The page's frame went through the browser's video and was encoded a second time; the pose
    // follows from corners that moved by hundredths of a pixel, which shifts edges of objects.
    assert.ok(mean(error) < 4, `mean ${mean(error)}`);
    assert.ok(share(error, 40) < 0.01, `${share(error, 40)} of the pixels`);

    // All the way to the right, the camera's own picture is there.
    await page.focus("#compare");
    await page.keyboard.press("End");
    const plain = differences(await canvasPixels(page), camera);
    assert.ok(mean(plain) < 4, `mean ${mean(plain)}`);
    assert.ok(share(plain, 40) < 0.01, `${share(plain, 40)} of the pixels`);
    assert.match(await page.textContent("#stages"), /composite/);
    assert.match(await page.textContent("#markers-used"), /marker 40/);
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
});

test("the scene's markers and the board are there to print", { skip }, async () => {
  const { page, complaints, close } = await openPage({ film, page: { locale: "de-AT" } });
  try {
    await page.goto(`http://${server.web}/`);
    const pdfOf = async (link) => {
      await link.waitFor();
      const answer = await page.request.get(await link.evaluate(({ href }) => href));
      assert.equal(answer.headers()["content-type"], "application/pdf");
      assert.match((await answer.body()).toString("latin1"), /^%PDF-/);
    };
    await pdfOf(page.locator("#notice .links a").first());
    await page.keyboard.press("p");
    await page.getByRole("button", { name: "Measure the lens" }).click();
    await pdfOf(page.locator(".board-sheets .links a").first());
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
});

test("a server that is started anew is found again", { skip }, async () => {
  const { page, close } = await openPage({ film });
  try {
    await startCamera(page, `http://${server.web}/`);
    await textMatches(page, "#summary", /fps/);
    const { webPort } = server;
    await server.stop();
    await textMatches(page, "#notice-title", /about to end|connection is lost/);
    server = await Server.start(SCENE, { ...OPTIONS, webPort });
    await textMatches(page, "#chip", /^connected/);
    await page.waitForFunction(() => document.getElementById("notice").hidden);
    // Until the first composite the page shows the camera alone.
    const isComposite = async () => share(differences(await canvasPixels(page), native), 40) < 0.01;
    for (let i = 0; i < 20 && !(await isComposite()); ++i) await page.waitForTimeout(200);
    assert.ok(await isComposite());
  } finally {
    await close();
  }
});
