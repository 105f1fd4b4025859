// The page in a browser, with a scripted server: what it shows and says, and when.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import jpeg from "jpeg-js";
import { CHROMIUM, closeBrowsers, openPage, startCamera, textMatches } from "../support/browser.js";
import { drawMarker, patternOf } from "../support/drawn_marker.js";
import { colored, writeFilm } from "../support/film.js";
import { buildFolder } from "../support/places.js";
import { StubServer, unchanged, WELCOME } from "../support/stub_server.js";

const skip = existsSync(CHROMIUM) ? false : "there is no Chromium";
const PAGE = join(buildFolder(), "web");
const CORNERS = [
  [90, 60],
  [210, 66],
  [206, 184],
  [84, 176],
].map(([x, y]) => ({ x, y }));

let folder;
const film = (name) => join(folder, `${name}.y4m`);

before(() => {
  folder = mkdtempSync(join(tmpdir(), "amalgam-film-"));
  const marker = drawMarker(patternOf("DICT_6X6_250", 40), CORNERS, 320, 240);
  writeFilm(film("marker"), [colored(marker)]);
});
after(async () => {
  await closeBrowsers();
  rmSync(folder, { recursive: true });
});

const poses = ({ corners }) =>
  corners.map(({ marker }) => ({ marker, translation: { x: 0, y: 0, z: 0.5 } }));

const friendly = {
  hello: (_, send) => send("welcome", WELCOME),
  cameraFrame: (frame, send) => send("composite", { ...unchanged(frame), poses: poses(frame) }),
};

/**
 * Runs f with a page and a server, and sees to it that both end and that nothing went wrong.
 * expected: what the browser may complain about
 */
async function withPage(
  { answers = friendly, expected = /^WebSocket connection to/, ...options },
  f,
) {
  const server = new StubServer(PAGE, answers);
  const address = await server.listen();
  const opened = await openPage(options);
  try {
    await f({ ...opened, server, address });
    const complaints = opened.complaints.filter((text) => !expected.test(text));
    assert.deepEqual(complaints, []); // what the content security policy forbids is among them
  } finally {
    await opened.close();
    await server.close();
  }
}

test("frames are sent with corners, and composites are shown", { skip }, async () => {
  await withPage({ film: film("marker") }, async ({ page, server, address }) => {
    await startCamera(page, address);
    await textMatches(page, "#summary", /fps/);
    const hello = server.received[0].value;
    assert.deepEqual([hello.camera.width, hello.camera.height], [320, 240]);
    assert.ok(Math.abs(hello.camera.fx - 160 * Math.sqrt(3)) < 1e-9);
    const { value } = server.received.findLast(({ kind }) => kind === "cameraFrame");
    assert.deepEqual([...value.jpeg.subarray(0, 2)], [0xff, 0xd8]);
    assert.deepEqual(
      value.corners.map(({ marker }) => marker),
      [40],
    );
    // The camera's way through the browser's video and its JPEG costs a little.
    value.corners[0].pixels.forEach((pixel, i) => {
      const expected = CORNERS[Math.floor(i / 2)][i % 2 ? "y" : "x"];
      assert.ok(Math.abs(pixel - expected) < 0.2, `${pixel} for ${expected}`);
    });
    assert.match(await page.textContent("#markers-used"), /marker 40, 0.50 m away, in view/);
    assert.match(await page.textContent("#passes"), /trace.*nothing specular/);
    assert.ok(await page.isHidden("#notice"));
    // Keys work from the slider too, and leave its own ones alone.
    await page.focus("#compare");
    await page.keyboard.press("p");
    assert.ok(await page.isVisible("#panel"));
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.inputValue("#compare"), "1");
    await page.keyboard.press("m");
    await page.waitForSelector("#outlines text");
    assert.equal(await page.textContent("#outlines text"), "40");
  });
});

test("slider, snapshot and film", { skip }, async () => {
  // Composites are black, so that one sees which part is the camera's: there its white paper is.
  const picture = { width: 320, height: 240, data: Buffer.alloc(320 * 240 * 4) };
  const black = new Uint8Array(jpeg.encode(picture, 90).data);
  const answers = {
    ...friendly,
    cameraFrame: ({ frameId, corners }, send) =>
      send("composite", { frameId, jpeg: black, poses: poses({ corners }), serverMs: 1 }),
  };
  await withPage({ answers, film: film("marker") }, async ({ page, address }) => {
    await startCamera(page, address);
    await textMatches(page, "#summary", /fps/);
    const levels = () =>
      page.evaluate(() => {
        const context = document.getElementById("canvas").getContext("2d");
        return [40, 280].map((x) => context.getImageData(x, 120, 1, 1).data[1]);
      });
    assert.deepEqual(await levels(), [0, 0]);
    await page.focus("#compare");
    for (let i = 0; i < 5; ++i) await page.keyboard.press("PageUp");
    const share = Number(await page.inputValue("#compare"));
    assert.ok(share > 20 && share < 80, `${share}`);
    const [left, right] = await levels();
    assert.ok(left > 200, `${left}`);
    assert.equal(right, 0);

    const snapshot = page.waitForEvent("download");
    await page.getByRole("button", { name: "Snapshot" }).click();
    const png = readFileSync(await (await snapshot).path());
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.equal(png.readUInt32BE(16), 320); // the camera's width, not the window's

    const saved = page.waitForEvent("download");
    await page.getByRole("button", { name: "Film" }).click();
    await page.waitForTimeout(700);
    await page.getByRole("button", { name: "Film" }).click();
    const download = await saved;
    assert.match(download.suggestedFilename(), /\.(webm|mp4)$/);
    assert.ok(readFileSync(await download.path()).length > 500);
  });
});

test("without a marker it says which one to look for", { skip }, async () => {
  const markers = { ...WELCOME.markers, ids: [7] }; // marker 40 is in view
  const answers = { ...friendly, hello: (_, send) => send("welcome", { ...WELCOME, markers }) };
  await withPage({ answers, film: film("marker") }, async ({ page, address }) => {
    await startCamera(page, address);
    await textMatches(page, "#notice-title", /No marker in view/);
    assert.match(await page.textContent("#notice-text"), /marker 7 \(DICT_6X6_250, 50 mm wide\)/);
  });
});

test("markers to print are offered, the user's paper first", { skip }, async () => {
  for (const [locale, first] of [
    ["de-AT", "A4"],
    ["en-US", "US Letter"],
  ]) {
    const options = { film: film("marker"), page: { locale } };
    await withPage(options, async ({ page, address }) => {
      await page.goto(address);
      const links = page.locator("#notice .links a");
      await links.first().waitFor();
      assert.equal(await links.first().textContent(), first);
      const targets = await links.evaluateAll((all) => all.map(({ href }) => href).sort());
      const sheet = `${address}marker-sheet.pdf?paper=`;
      assert.deepEqual(targets, [`${sheet}a4`, `${sheet}letter`]);
      // Beside other news they would be in the way.
      await page.getByRole("button", { name: "Start the camera" }).click();
      await textMatches(page, "#summary", /fps/);
      assert.ok(await page.isHidden("#notice"));
    });
  }
});

test("a scene that cannot be printed has no such links", { skip }, async () => {
  const server = new StubServer(PAGE, friendly);
  server.prints = false;
  const address = await server.listen();
  const { page, close } = await openPage({ film: film("marker") });
  try {
    const asked = page.waitForResponse(/marker-sheet/);
    await page.goto(address);
    assert.equal((await asked).status(), 404);
    await page.waitForTimeout(200);
    assert.ok(await page.isHidden("#notice .marker-sheets"));
  } finally {
    await close();
    await server.close();
  }
});

test("calibrations are read as YAML and as XML", { skip }, async () => {
  const matrix = (rows, cols, data) =>
    `type_id="opencv-matrix"><rows>${rows}</rows><cols>${cols}</cols><dt>d</dt>` +
    `<data>${data}</data>`;
  const xml = `<?xml version="1.0"?>
<opencv_storage>
<image_width>320</image_width><image_height>240</image_height>
<camera_matrix ${matrix(3, 3, "300. 0. 160. 0. 301. 120. 0. 0. 1.")}</camera_matrix>
<distortion_coefficients ${matrix(5, 1, "1.e-01 -2.e-02 0. 0. 0.")}</distortion_coefficients>
</opencv_storage>`;
  // With damaged XML Chromium makes a document whose style the page's policy forbids.
  const options = { film: film("marker"), expected: /^Applying inline style/ };
  await withPage(options, async ({ page, server, address }) => {
    await page.goto(address);
    await page.keyboard.press("p");
    const choose = (name, text) => {
      const buffer = Buffer.from(text);
      return page.setInputFiles("#calibration", { name, mimeType: "text/plain", buffer });
    };
    await choose("wrong.xml", "<svg/>");
    await textMatches(page, "#calibration-state", /it is XML, but not OpenCV's/);
    await choose("broken.xml", "<opencv_storage><a>");
    await textMatches(page, "#calibration-state", /broken\.xml: .*the XML is damaged/);
    await choose("lens.xml", xml);
    await textMatches(page, "#calibration-state", /lens\.xml: fx 300\.0, 56\.1° wide/);
    await page.getByRole("button", { name: "Apply" }).click();
    await textMatches(page, "#chip", /^connected/);
    const { camera } = server.received[0].value;
    assert.deepEqual([camera.fx, camera.fy, camera.cx, camera.cy], [300, 301, 160, 120]);
    assert.deepEqual(camera.distortion, [0.1, -0.02, 0, 0, 0]);
  });
});

test("without a camera, and without the permission, it says so", { skip }, async () => {
  await withPage({ film: null }, async ({ page, address, server }) => {
    await startCamera(page, address);
    await textMatches(page, "#notice-title", /No camera was found/);
    assert.deepEqual(server.received, []);
  });
  await withPage({ film: film("marker"), allow: false }, async ({ page, address }) => {
    await startCamera(page, address);
    await textMatches(page, "#notice-title", /The camera is not allowed/);
  });
});

test("a full server is waited for, with a count-down", { skip }, async () => {
  const full = {
    hello: (_, send, socket) => {
      send("busy", { retryAfterMs: 2000, reason: "too many connections" });
      socket.close();
    },
  };
  await withPage({ answers: full, film: film("marker") }, async ({ page, address, server }) => {
    await startCamera(page, address);
    await textMatches(page, "#notice-title", /The server is full/);
    assert.match(await page.textContent("#notice-text"), /too many connections/);
    await textMatches(page, "#notice-countdown", /in [23] s/);
    await textMatches(page, "#notice-countdown", /in 1 s/);
    server.answers = friendly;
    await textMatches(page, "#chip", /^connected/);
  });
});

test("a wrong token is said, and the right one is taken", { skip }, async () => {
  const answers = {
    ...friendly,
    hello: ({ token }, send) => {
      if (token === "sesame") send("welcome", WELCOME);
      else send("error", { code: 5, text: "wrong token", closes: true });
    },
  };
  await withPage({ answers, film: film("marker") }, async ({ page, address }) => {
    await startCamera(page, address);
    await textMatches(page, "#notice-title", /The token is wrong/);
    await page.getByRole("button", { name: "Open the settings" }).click();
    await page.keyboard.type("sesame"); // the field has the focus
    await page.keyboard.press("Enter");
    await textMatches(page, "#chip", /^connected/);
    const kept = await page.evaluate(() => JSON.stringify(localStorage));
    assert.ok(!kept.includes("sesame"), kept);
  });
});

test("a server that ends is said, and a new one is found", { skip }, async () => {
  await withPage({ film: film("marker") }, async ({ page, address, server }) => {
    await startCamera(page, address);
    await textMatches(page, "#summary", /fps/);
    const { port } = server;
    await server.close();
    await textMatches(page, "#notice-title", /The connection is lost/);
    const next = new StubServer(PAGE, friendly);
    await next.listen(port);
    await textMatches(page, "#chip", /^connected/);
    await page.waitForFunction(() => document.getElementById("notice").hidden);
    await next.close();
  });
});
