// What the page remembers, says and counts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Figures } from "amalgam-page/figures.js";
import { Lenses } from "amalgam-page/lenses.js";
import { sessionAddress } from "amalgam-page/server_address.js";
import { DEFAULTS, parseSettings } from "amalgam-page/settings.js";
import { papersFor } from "amalgam-page/sheets.js";
import { cameraNotice, countDown, noMarkerNotice, sessionNotice } from "amalgam-page/words.js";

const HTTP = { protocol: "http:", host: "desk:8080" };
const HTTPS = { protocol: "https:", host: "desk" };

test("the server is the page's own unless another was typed", () => {
  assert.equal(sessionAddress("", HTTP), "ws://desk:8080/session");
  assert.equal(sessionAddress("", HTTPS), "wss://desk/session");
  assert.equal(sessionAddress(" other:1 ", HTTP), "ws://other:1/session");
  assert.equal(sessionAddress("https://other/a/session", HTTPS), "wss://other/a/session");
  assert.throws(() => sessionAddress("ws://other", HTTPS), /wss/);
  assert.throws(() => sessionAddress("a b", HTTP), /not an address/);
  assert.throws(() => sessionAddress("ftp://other", HTTP), /cannot|not an address/);
});

test("settings of other versions and damaged ones do no harm", () => {
  assert.deepEqual(parseSettings(null), DEFAULTS);
  assert.deepEqual(parseSettings("{not json"), DEFAULTS);
  const saved = { fieldOfView: "wide", size: "320x240", calibration: 5, unknown: 1 };
  assert.deepEqual(parseSettings(JSON.stringify(saved)), { ...DEFAULTS, size: "320x240" });
});

test("paper is what letters are written on there", () => {
  assert.deepEqual(papersFor("en-US"), ["letter", "a4"]);
  assert.deepEqual(papersFor("en"), ["letter", "a4"]); // most likely of the United States
  assert.deepEqual(papersFor("es-MX"), ["letter", "a4"]);
  for (const language of ["en-GB", "de", "fr-FR", "zh-Hans", "not a language", ""]) {
    assert.deepEqual(papersFor(language), ["a4", "letter"], language);
  }
});

test("lenses are remembered by camera and size, the newest ones", () => {
  const saved = new Map();
  const storage = {
    getItem: (key) => saved.get(key) ?? null,
    setItem: (key, value) => saved.set(key, value),
  };
  const lenses = new Lenses(storage);
  assert.equal(lenses.find("a", 640, 480), null);
  lenses.keep("a", 640, 480, { text: "first", error: 0.3 });
  lenses.keep("a", 320, 240, { text: "small", error: 0.2 });
  lenses.keep("a", 640, 480, { text: "second", error: 0.1 });
  const later = new Lenses(storage);
  assert.deepEqual(later.find("a", 640, 480), { text: "second", error: 0.1 });
  assert.equal(later.find("a", 320, 240).text, "small");
  assert.equal(later.find("b", 640, 480), null);
  later.forget("a", 640, 480);
  assert.equal(new Lenses(storage).find("a", 640, 480), null);
  for (let i = 0; i < 30; ++i) later.keep(`camera ${i}`, 1, 1, { text: "t", error: 0 });
  assert.equal(new Lenses(storage).list.length, 20);
  assert.equal(later.find("a", 320, 240), null);
  assert.equal(later.find("camera 29", 1, 1).text, "t");
});

test("without storage, or with nonsense in it, lenses are known until the page is closed", () => {
  const forbidden = {
    getItem: () => {
      throw new Error("forbidden");
    },
    setItem: () => {
      throw new Error("forbidden");
    },
  };
  for (const storage of [null, forbidden, { getItem: () => "{}", setItem: () => {} }]) {
    const lenses = new Lenses(storage);
    lenses.keep("a", 1, 1, { text: "t", error: 0 });
    assert.equal(lenses.find("a", 1, 1).text, "t");
  }
  const odd = new Lenses({ getItem: () => '[["a 1x1", {"text": 5}], ["a 2x2", {"text": "t"}]]' });
  assert.equal(odd.list.length, 1);
});

test("each failure has words of its own", () => {
  const reasons = ["insecure", "denied", "none", "busy", "failed", "ended"];
  assert.equal(new Set(reasons.map((reason) => cameraNotice(reason).title)).size, reasons.length);
  assert.equal(sessionNotice({ kind: "ready" }), null);
  assert.match(sessionNotice({ kind: "busy", reason: "too many" }).text, /too many/);
  assert.match(sessionNotice({ kind: "refused", code: "AUTH_FAILED", text: "" }).title, /token/);
  assert.match(sessionNotice({ kind: "refused", code: "X", text: "odd" }).text, /odd/);
  const markers = { dictionary: "DICT_4X4_50", ids: [40], length: 0.05 };
  assert.match(noMarkerNotice(markers).text, /marker 40 \(DICT_4X4_50, 50 mm wide\)/);
});

test("seconds run down to now", () => {
  assert.equal(countDown(undefined, 0), "");
  assert.equal(countDown(2500, 0), "Trying again in 3 s.");
  assert.equal(countDown(2500, 1501), "Trying again in 1 s.");
  assert.equal(countDown(2500, 2600), "Trying again now.");
});

test("a frame's time is divided without a rest", () => {
  const figures = new Figures();
  const stages = [
    { name: "trace", milliseconds: 30 },
    { name: "encode", milliseconds: 5 },
  ];
  const composite = { serverMs: 40, stages };
  const frame = { captured: 100, sent: 130, times: { read: 3, search: 12, encode: 5 } };
  figures.add(composite, frame, { received: 190, decoded: 194, shown: 195 });
  const average = (name) => figures.average(name);
  assert.deepEqual(["wait", "network", "decode", "show", "total"].map(average), [10, 20, 4, 1, 95]);
  const parts = ["wait", "read", "search", "encode", "network", "server", "decode", "show"];
  assert.equal(
    parts.map(average).reduce((a, b) => a + b),
    average("total"),
  );
  assert.deepEqual(figures.serverStages(), [
    ["trace", 30],
    ["encode", 5],
  ]);
  assert.deepEqual([figures.shown, figures.late], [1, 0]);
});

test("late frames are counted, and stages that no longer run disappear", () => {
  const figures = new Figures();
  const frame = { captured: 0, sent: 10, times: { read: 1, search: 1, encode: 1 } };
  const at = { received: 400, decoded: 401, shown: 402 };
  figures.add({ serverMs: 300, stages: [{ name: "trace", milliseconds: 200 }] }, frame, at);
  figures.add({ serverMs: 300, stages: [] }, frame, at);
  assert.equal(figures.late, 2);
  assert.deepEqual(figures.serverStages(), []);
});
