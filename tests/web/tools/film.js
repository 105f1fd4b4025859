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
const EVERY = 3; // of them is shown
// Pictures a second: for the film as many as a busy server without a GPU can follow, and for the
// picture that shows times a camera's.
const FILM_RATE = 1;
const PICTURE_RATE = 15;
const FRAMES = PATH / EVERY;
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
    { timeout: PATIENCE_MS },
  );

const setShare = (page, share) =>
  page.evaluate((value) => {
    const slider = document.getElementById("compare");
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  }, share);

const [, , out] = argv;
mkdirSync(out, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), "amalgam-film-"));
let server;
try {
  const desk = await deskPictures(folder, SIZE, PATH);
  const shown = desk.filter((_, i) => i % EVERY === 0);
  const pictures = shown.map((bytes) => jpeg.decode(bytes, { useTArray: true }));
  const filmOf = (rate) => {
    const file = join(folder, `desk-${rate}.y4m`);
    writeFilm(file, pictures, rate);
    return file;
  };
  const folderOfPage = join(buildFolder(), "web");
  server = await Server.start(sceneFile("complex"), {
    options: ["--samples", "adaptive", "--web-folder", folderOfPage],
  });
  const open = async (rate, [width, height]) => {
    const film = filmOf(rate);
    const settings = { viewport: { width, height }, colorScheme: "light" };
    const opened = await openPage({ film, page: settings });
    await startCamera(opened.page, `http://${server.web}/`);
    await textMatches(opened.page, "#summary", /fps/, PATIENCE_MS);
    return opened;
  };

  const forFilm = await open(FILM_RATE, [880, 660]);
  // The film is not made in real time.
  await forFilm.page.evaluate(() => (document.getElementById("summary").style.opacity = 0));
  for (let frame = 0; frame < FRAMES; ++frame) {
    await nextPicture(forFilm.page);
    await setShare(forFilm.page, shareAt(frame));
    const name = `film-${String(frame).padStart(3, "0")}.png`;
    await forFilm.page.screenshot({ path: join(out, name) });
  }
  await forFilm.close();

  const { page, close } = await open(PICTURE_RATE, [1280, 800]);
  await page.keyboard.press("p");
  await setShare(page, 50);
  await page.waitForTimeout(3000);
  // Where the time goes, rather than the settings.
  await page.evaluate(() => document.getElementById("figures").scrollIntoView());
  await nextPicture(page);
  await page.screenshot({ path: join(out, "page.png") });
  await close();
} finally {
  await server?.stop();
  await closeBrowsers();
  rmSync(folder, { recursive: true });
}
