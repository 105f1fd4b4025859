// How much later the page shows a composite than the native client has it: both beside a server
// whose renderer takes a known time, with the same film, in turns.
//
//   ninja -C build amalgam_web amalgam-client amalgam-stub-server
//   node build/web-packages/tests/tools/latency.mjs [--runs 5] [--cost 20] [--size 640x480]
//
// Times of a busy machine count only beside each other. The native client's begins when it has the
// decoded picture of its film, and ends when the composite has come; it does not decode it. The
// page's begins with the camera's own time of capture, and ends when the composite is drawn.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import jpeg from "jpeg-js";
import { closeBrowsers, openPage, startCamera, textMatches } from "../support/browser.js";
import { writeFilm } from "../support/film.js";
import { deskPictures, nativeLatency, Server } from "../support/programs.js";

const PICTURES = 20;
const REPEATED = 6; // for the native client, whose film ends
const WARM_UP_FRAMES = 60; // until the browser has compiled what it runs often
const PATIENCE_MS = 120000;
const SAMPLES = 10;
const SAMPLE_MS = 500; // how often the page says its figures

const { values: options } = parseArgs({
  options: {
    runs: { type: "string", default: "5" },
    cost: { type: "string", default: "20" },
    size: { type: "string", default: "640x480" },
    rate: { type: "string", default: "30" },
  },
});

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

/** @returns {Promise<Map<string, number>>} ms by stage: medians of what the page says */
async function pageTimes(address, film) {
  const { page, close } = await openPage({ film });
  try {
    await page.goto(address);
    await page.selectOption("#size", options.size).catch(() => {});
    await startCamera(page, address);
    await textMatches(page, "#summary", /fps/, PATIENCE_MS);
    await page.waitForFunction(
      (frames) =>
        [...document.querySelectorAll("#frames tr")].some(
          ({ cells }) => cells[0].textContent === "shown" && Number(cells[1].textContent) >= frames,
        ),
      WARM_UP_FRAMES,
      { timeout: PATIENCE_MS },
    );
    const all = new Map();
    for (let i = 0; i < SAMPLES; ++i) {
      await page.waitForTimeout(SAMPLE_MS);
      const rows = await page.evaluate(() =>
        [...document.querySelectorAll("#stages tr:not(.inner), #frames tr")].map((tr) => [
          tr.cells[0].textContent,
          parseFloat(tr.cells[1].textContent),
        ]),
      );
      for (const [name, value] of rows) all.set(name, [...(all.get(name) ?? []), value]);
    }
    return new Map([...all].map(([name, values]) => [name, median(values)]));
  } finally {
    await close();
  }
}

const folder = mkdtempSync(join(tmpdir(), "amalgam-latency-"));
let server;
try {
  const bytes = await deskPictures(folder, options.size, PICTURES);
  const pictures = bytes.map((data) => jpeg.decode(data, { useTArray: true }));
  const rate = Number(options.rate);
  const film = join(folder, "desk.y4m");
  writeFilm(film, Array(REPEATED).fill(pictures).flat(), rate);
  server = await Server.startStub(Number(options.cost));
  const native = [];
  const page = [];
  for (let run = 0; run < Number(options.runs); ++run) {
    native.push(nativeLatency(server.address, film, rate));
    page.push(await pageTimes(`http://${server.web}/`, film));
    const total = page.at(-1).get("capture to screen");
    console.log(
      `run ${run + 1}: native ${native.at(-1).toFixed(1)} ms, page ${total.toFixed(1)} ms, ` +
        `${(total - native.at(-1)).toFixed(1)} more, ratio ${(total / native.at(-1)).toFixed(2)}`,
    );
  }
  for (const name of page[0].keys()) {
    const value = median(page.map((times) => times.get(name)));
    console.log(`  ${name.padEnd(24)} ${value.toFixed(1).padStart(7)}`);
  }
  const totals = page.map((times) => times.get("capture to screen"));
  const more = median(totals.map((total, i) => total - native[i]));
  const ratio = median(totals.map((total, i) => total / native[i]));
  console.log(
    `median of ${native.length}: the page shows ${more.toFixed(1)} ms later (x ${ratio.toFixed(2)})`,
  );
} finally {
  await server?.stop();
  await closeBrowsers();
  rmSync(folder, { recursive: true });
}
