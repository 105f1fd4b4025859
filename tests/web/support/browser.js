// A headless Chromium with a film for a camera.
import { chromium } from "playwright-core";

export const CHROMIUM = process.env.AMALGAM_CHROMIUM ?? "/usr/bin/chromium";

const BASE = ["--no-sandbox", "--disable-gpu", "--mute-audio", "--no-first-run"];

// A camera belongs to the whole browser, and starting one takes seconds: one for each film.
const browsers = new Map();

async function browserWith(film) {
  if (browsers.has(film)) return browsers.get(film);
  const camera = film
    ? ["--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${film}`]
    : ["--use-fake-device-for-media-stream=device-count=0"];
  const args = [...BASE, ...camera];
  const browser = await chromium.launch({ executablePath: CHROMIUM, headless: true, args });
  browsers.set(film, browser);
  return browser;
}

/**
 * A page of its own, with nothing remembered.
 * @param {{film?: string | null, allow?: boolean, page?: object}} options film: MJPEG or Y4M; null
 *   for no camera at all. allow: whether the user lets the page have it. page: playwright's options
 */
export async function openPage({ film = null, allow = true, page: pageOptions = {} } = {}) {
  const browser = await browserWith(film);
  const permissions = allow ? ["camera"] : [];
  const context = await browser.newContext({ permissions, ...pageOptions });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  return { page, complaints, close: () => context.close() };
}

/** To be called at the end of a file of tests. */
export async function closeBrowsers() {
  for (const browser of browsers.values()) await browser.close();
  browsers.clear();
}

/** Opens the page and starts its camera. */
export async function startCamera(page, address) {
  await page.goto(address);
  await page.getByRole("button", { name: "Start the camera" }).click();
}

/** @returns {Promise<void>} when the element's text matches, or an error after ms */
export async function textMatches(page, selector, pattern, ms = 8000) {
  await page.waitForFunction(
    ([at, source]) => new RegExp(source).test(document.querySelector(at).textContent),
    [selector, pattern.source],
    { timeout: ms },
  );
}
