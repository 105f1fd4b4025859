// The status page in a browser, with a real server and two sessions: what it shows is what the
// server says, and it says so when the server is gone.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { CHROMIUM, closeBrowsers, openPage, textMatches } from "../support/browser.js";
import { Load, sceneFile, Server } from "../support/programs.js";

const skip = existsSync(CHROMIUM) ? false : "there is no Chromium";
// Needs no OpenGL, and is quick on two cores.
const OPTIONS = ["--renderer", "raytrace", "--admin-pictures", "--max-load", "0"];

let server;
let load;

before(async () => {
  if (skip) return;
  server = await Server.start(sceneFile("diffuse"), { options: OPTIONS });
  load = new Load(server.address, ["--clients", "2", "--rate", "4", "--size", "320x240"]);
});

after(async () => {
  await load?.stop();
  await server?.stop();
  await closeBrowsers();
});

const stateOf = async () => (await fetch(`http://${server.admin}/state`)).json();

/**
 * Opens the page, waits for both sessions, and runs f.
 * @param {object} options playwright's, and prepare: called with the page before it is opened
 */
async function withPage({ prepare, ...options }, f) {
  const { page, complaints, close } = await openPage({ page: options });
  try {
    await prepare?.(page);
    await page.goto(`http://${server.admin}/`);
    await page.waitForFunction(
      () => document.querySelectorAll("#sessions > tbody > tr:not(.details)").length === 2,
    );
    await f(page, complaints);
  } finally {
    await close();
  }
}

/** @returns {Promise<string>} of a column of the first session */
const cell = (page, head) => page.textContent(`#sessions > tbody > tr td[data-label="${head}"]`);

test("it shows what the server says", { skip }, async () => {
  await withPage({}, async (page, complaints) => {
    await textMatches(page, "#chip", /^ready$/);
    const { sessions, limits, version } = await stateOf();
    assert.ok((await page.textContent("#about")).startsWith(`${version} · up `));
    assert.equal(await page.textContent("#sessions-title"), "2 sessions");
    assert.equal(await cell(page, "Address"), `${sessions[0].peer} · tcp`);
    assert.equal(await cell(page, "Size"), "320 × 240");
    assert.equal(
      await page.textContent("#limit-connections .value"),
      `2 of ${limits.connections.most}`,
    );
    // Counts go on; the page's are from between what was said before and what is said after.
    await page.waitForTimeout(1500);
    const [size, unit] = (await cell(page, "Sent")).split(" ");
    const shown = Number(size) * { B: 1, kB: 1e3, MB: 1e6 }[unit];
    const after = (await stateOf()).sessions[0].bytes_sent;
    const before = sessions[0].bytes_sent;
    const rounded = 0.005; // to three digits
    assert.ok(before * (1 - rounded) <= shown && shown <= after * (1 + rounded));
    assert.ok(after > before);
    const asked = Number(await cell(page, "Asks, fps"));
    assert.ok(asked > 0.5 && asked < 12, `${asked}`);
    assert.deepEqual(complaints, []); // what the content security policy forbids is among them
  });
});

test("a session is opened by the keyboard and tells what was left out", { skip }, async () => {
  await withPage({}, async (page, complaints) => {
    const button = page.getByRole("button", { name: /^Session/ }).first();
    await button.focus();
    await page.keyboard.press("Enter");
    assert.equal(await button.getAttribute("aria-expanded"), "true");
    await page.waitForFunction(
      () => document.querySelectorAll(".session-details caption").length === 3,
    );
    const { passes } = (await stateOf()).sessions[0];
    const left = passes.filter(({ ran }) => !ran);
    assert.ok(left.length > 3);
    const rows = await page
      .locator(".session-details table:nth-child(2) tbody tr")
      .evaluateAll((all) => all.map((row) => [...row.cells].map((part) => part.textContent)));
    assert.deepEqual(
      rows,
      left.map(({ name, reason }) => [name.replaceAll("_", " "), reason]),
    );
    const ran = page.locator(".session-details table:nth-child(1) tbody tr");
    assert.equal(await ran.count(), passes.length - left.length);
    assert.match(await ran.filter({ hasText: "composite" }).textContent(), /composite\d/);
    // It stays open and keeps the focus while the page is filled anew.
    await page.waitForTimeout(1500);
    assert.equal(await button.getAttribute("aria-expanded"), "true");
    assert.ok(await button.evaluate((element) => element === document.activeElement));
    assert.deepEqual(complaints, []);
  });
});

/** @returns {Promise<number>} pixels of the chart that have the color of one of its lines */
const drawn = (page, id) =>
  page.evaluate((chart) => {
    const canvas = document.querySelector(`#chart-${chart} canvas`);
    if (!canvas) return 0;
    const colors = [...document.querySelectorAll(`#chart-${chart} .swatch`)].map((swatch) =>
      getComputedStyle(swatch).backgroundColor.match(/\d+/g).map(Number),
    );
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      const near = ([r, g, b]) =>
        Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 60;
      if (data[i + 3] > 200 && colors.some(near)) ++count;
    }
    return count;
  }, id);

test("the charts are drawn, and say their newest values", { skip }, async () => {
  await withPage({}, async (page, complaints) => {
    const ids = ["frames", "stages", "delay", "connections", "processor", "memory"];
    for (const id of ids) {
      let pixels = 0; // lines need a few answers
      for (let i = 0; i < 100 && pixels < 2; ++i) {
        await page.waitForTimeout(200);
        pixels = await drawn(page, id);
      }
      assert.ok(pixels > 1, `${id}: ${pixels} pixels`);
    }
    const { sessions } = await stateOf();
    const values = await page.locator("#chart-connections output").allTextContents();
    assert.deepEqual(values.map(Number), [2, sessions.length]);
    const received = Number(await page.locator("#chart-frames output").first().textContent());
    assert.ok(received > 1 && received < 24, `${received}`);
    assert.match(await page.textContent("#chart-stages"), /composite\d/);
    assert.deepEqual(complaints, []);
  });
});

test("pictures are shown where the operator wants that", { skip }, async () => {
  await withPage({}, async (page, complaints) => {
    await page.waitForFunction(() => document.querySelector(".picture img")?.naturalWidth === 320);
    const address = await page.getAttribute(".picture img", "src");
    await page.waitForFunction(
      (before) => document.querySelector(".picture img").getAttribute("src") !== before,
      address,
    );
    assert.match(await page.textContent("#pictures-hint"), /--admin-pictures/);
    assert.deepEqual(complaints, []);
  });
});

test("what comes from strangers stays text", { skip }, async () => {
  const evil = '<img src="x" onerror="window.hurt = 1"><b>bold</b>';
  const prepare = (page) =>
    page.route("**/state", async (route) => {
      const state = await (await route.fetch()).json();
      state.not_ready = evil;
      state.ready = false;
      for (const session of state.sessions) {
        Object.assign(session, { peer: evil, transport: evil, state: evil, picture: false });
        session.passes = [{ name: evil, ran: false, reason: evil }];
        session.stages_ms = { [evil]: 1 };
        session.skipped_by = { [evil]: 1 };
      }
      await route.fulfill({ json: state });
    });
  await withPage({ prepare }, async (page, complaints) => {
    await page.getByRole("button", { name: /^Session/ }).first().click();
    assert.equal(await cell(page, "Address"), `${evil} · ${evil}`);
    assert.ok((await page.textContent("#chip")).includes(evil));
    assert.ok((await page.textContent(".session-details")).includes(evil));
    assert.equal(await page.evaluate(() => window.hurt), undefined);
    assert.equal(await page.locator("main b").count(), 0);
    assert.deepEqual(complaints, []);
  });
});

test("it fits a phone", { skip }, async () => {
  await withPage({ viewport: { width: 360, height: 740 } }, async (page) => {
    await page.getByRole("button", { name: /^Session/ }).first().click();
    await page.waitForSelector(".session-details caption");
    const { whole, screen } = await page.evaluate(() => ({
      whole: document.documentElement.scrollWidth,
      screen: innerWidth,
    }));
    assert.ok(whole <= screen, `${whole} px on a screen of ${screen}`);
  });
});

// The last one: it ends the server.
test("a killed server is said, and found again", { skip }, async () => {
  await withPage({}, async (page) => {
    assert.ok(await page.isHidden("#banner"));
    const { adminPort } = server;
    await server.kill();
    await page.waitForSelector("#banner:not([hidden])");
    assert.match(await page.textContent("#banner-text"), /has not answered since \d/);
    assert.equal(await page.getAttribute("#banner-text", "role"), "alert");
    assert.equal(await page.textContent("#chip"), "no answer");
    await textMatches(page, "#banner-age", /^[2-9] s$/);
    server = await Server.start(sceneFile("diffuse"), { adminPort, options: OPTIONS });
    await page.waitForSelector("#banner", { state: "hidden" });
    await textMatches(page, "#chip", /^ready$/);
    await textMatches(page, "#no-sessions", /none/);
    assert.ok(await page.isVisible("#no-sessions")); // the sessions went with the old server
  });
});
