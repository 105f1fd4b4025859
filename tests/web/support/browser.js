// A headless Chromium with a film for a camera.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

export const CHROMIUM = process.env.AMALGAM_CHROMIUM ?? "/usr/bin/chromium";

const BASE = ["--no-sandbox", "--disable-gpu", "--mute-audio", "--no-first-run"];

/**
 * @param {{film?: string | null, allow?: boolean, page?: object}} options film: MJPEG or Y4M; null
 *   for no camera at all. allow: whether the user lets the page have it. page: playwright's options
 */
export async function openBrowser({ film = null, allow = true, page: pageOptions = {} } = {}) {
  const camera = film
    ? ["--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${film}`]
    : ["--use-fake-device-for-media-stream=device-count=0"];
  const profile = mkdtempSync(join(tmpdir(), "amalgam-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: CHROMIUM,
    headless: true,
    args: [...BASE, ...camera],
    permissions: allow ? ["camera"] : [],
    acceptDownloads: true,
    ...pageOptions,
  });
  const page = context.pages()[0] ?? (await context.newPage());
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  const close = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  };
  return { page, complaints, close };
}

/** Opens the page and starts its camera. */
export async function startCamera(page, address) {
  await page.goto(address);
  await page.getByRole("button", { name: "Start the camera" }).click();
}

/** @returns {Promise<void>} when the element's text matches, or an error after 8 s */
export async function textMatches(page, selector, pattern) {
  await page.waitForFunction(
    ([at, source]) => new RegExp(source).test(document.querySelector(at).textContent),
    [selector, pattern.source],
    { timeout: 8000 },
  );
}
