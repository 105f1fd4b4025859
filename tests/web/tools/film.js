// Pictures of the page at work, for the README: a film's frames and one picture with the panel open.
// deploy/pictures_page.sh makes WebP of them.
//
//   node build/web-packages/tests/tools/film.mjs FOLDER
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { argv } from "node:process";
import jpeg from "jpeg-js";
import { closeBrowsers, openPage, startCamera, textMatches } from "../support/browser.js";
import { writeFilm } from "../support/film.js";
import { buildFolder } from "../support/places.js";
import { deskPictures, sceneFile, Server } from "../support/programs.js";

const SIZE = "640x480";
const PATH = 240; // pictures until the synthetic camera begins again
const EVERY = 4; // of them is shown
const RATE = 15; // of the camera for the picture that shows times
const FRAMES = PATH / EVERY;
const RETAKE_MS = 6000;
const PATIENCE_MS = 120000; // the first picture waits for the shaders

// The slider goes to the middle, waits, and goes back.
function shareAt(frame) {
  const [out, stay, back] = [0.3, 0.5, 0.7].map((part) => part * FRAMES);
  const ease = (t) => Math.min(Math.max(t, 0), 1) ** 2 * (3 - 2 * Math.min(Math.max(t, 0), 1));
  const length = 0.15 * FRAMES;
  const middle = 50;
  if (frame < stay) return Math.round(middle * ease((frame - out) / length));
  return Math.round(middle * (1 - ease((frame - back) / length)));
}

/** In the page: a camera that takes its next picture when it is told to, however long that takes. */
function patientCamera() {
  const canvas = document.createElement("canvas");
  const stream = canvas.captureStream(0);
  navigator.mediaDevices.getUserMedia = async () => stream;
  window.takePicture = async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/jpeg" }));
    [canvas.width, canvas.height] = [bitmap.width, bitmap.height];
    canvas.getContext("2d").drawImage(bitmap, 0, 0);
    stream.getVideoTracks()[0].requestFrame();
  };
}

/** Waits for another picture on the canvas than the last time. */
const nextPicture = (page) =>
  page.waitForFunction(
    () => {
      const canvas = document.getElementById("canvas");
      const { data } = canvas.getContext("2d").getImageData(0, canvas.height - 8, canvas.width, 8);
      const sum = data.reduce((a, b) => (31 * a + b) % 4294967291, 0);
      const isNew = sum !== window.lastSum;
      window.lastSum = sum;
      return isNew;
    },
    null,
    { timeout: RETAKE_MS },
  );

/** A picture is skipped while another one is under way; then it is taken again. */
async function showPicture(page, bytes) {
  for (;;) {
    await page.evaluate((base64) => window.takePicture(base64), bytes.toString("base64"));
    try {
      return await nextPicture(page);
    } catch (error) {
      if (error.name !== "TimeoutError") throw error;
    }
  }
}

const setShare = (page, share) =>
  page.evaluate((value) => {
    const slider = document.getElementById("compare");
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  }, share);

async function takeFilm(address, pictures) {
  const settings = { viewport: { width: 880, height: 660 }, colorScheme: "light" };
  const { page, close } = await openPage({ page: settings });
  await page.addInitScript(patientCamera);
  await startCamera(page, address);
  await showPicture(page, pictures.at(-2)); // the camera alone, until there is a session
  await textMatches(page, "#chip", /^connected/, PATIENCE_MS);
  await showPicture(page, pictures.at(-1));
  // The film is not made in real time.
  await page.evaluate(() => (document.getElementById("summary").style.opacity = 0));
  for (let frame = 0; frame < FRAMES; ++frame) {
    await showPicture(page, pictures[frame]);
    await setShare(page, shareAt(frame));
    await page.screenshot({ path: join(out, `film-${String(frame).padStart(3, "0")}.png`) });
  }
  await close();
}

async function takePicture(address, pictures) {
  const film = join(folder, "desk.y4m");
  writeFilm(
    film,
    pictures.map((bytes) => jpeg.decode(bytes, { useTArray: true })),
    RATE,
  );
  const settings = { viewport: { width: 1280, height: 800 }, colorScheme: "light" };
  const { page, close } = await openPage({ film, page: settings });
  await startCamera(page, address);
  await textMatches(page, "#summary", /fps/, PATIENCE_MS);
  await page.keyboard.press("p");
  await setShare(page, 50);
  await page.waitForTimeout(3000);
  // Where the time goes, rather than the settings.
  await page.evaluate(() => document.getElementById("figures").scrollIntoView());
  await nextPicture(page);
  await page.screenshot({ path: join(out, "page.png") });
  await close();
}

const [, , out] = argv;
mkdirSync(out, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), "amalgam-film-"));
let server;
try {
  // The scene's mirror on the left is a real one.
  const desk = await deskPictures(folder, SIZE, PATH, ["--synthetic-mirror"]);
  const shown = desk.filter((_, i) => i % EVERY === 0);
  const pageFolder = join(buildFolder(), "web");
  server = await Server.start(sceneFile("complex"), {
    options: ["--samples", "adaptive", "--web-folder", pageFolder],
  });
  const address = `http://${server.web}/`;
  await takeFilm(address, shown);
  await takePicture(address, shown);
} finally {
  await server?.stop();
  await closeBrowsers();
  rmSync(folder, { recursive: true });
}
