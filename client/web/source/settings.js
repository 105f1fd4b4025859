// What the page remembers from one visit to the next. The token is a secret: it is kept only until
// the browser's tab is closed.

const KEY = "amalgam";
const TOKEN_KEY = "amalgam-token";

export const DEFAULTS = Object.freeze({
  deviceId: "",
  size: "640x480",
  fieldOfView: 60,
  calibration: null, // {name, text}
  server: "",
  quality: 92, // of the camera's JPEG, percent
  steady: false,
  markers: false, // whether their outlines are drawn
});

/** @returns {object} what was saved and still makes sense, and DEFAULTS for the rest */
export function parseSettings(text) {
  let saved;
  try {
    saved = JSON.parse(text) ?? {};
  } catch {
    saved = {};
  }
  const settings = { ...DEFAULTS };
  for (const [name, value] of Object.entries(DEFAULTS)) {
    const kept = saved[name];
    if (value === null ? typeof kept?.text === "string" : typeof kept === typeof value) {
      settings[name] = kept;
    }
  }
  return settings;
}

/** @returns {{width: number, height: number}} of "640x480" */
export function parseSize(text) {
  const [width, height] = text.split("x").map(Number);
  return { width, height };
}

// Storage throws where the browser forbids it; then nothing is remembered, and that is all.
function quietly(f) {
  try {
    return f();
  } catch {
    return null;
  }
}

export function loadSettings() {
  const settings = parseSettings(quietly(() => localStorage.getItem(KEY)));
  return { ...settings, token: quietly(() => sessionStorage.getItem(TOKEN_KEY)) ?? "" };
}

export function saveSettings({ token, ...settings }) {
  quietly(() => localStorage.setItem(KEY, JSON.stringify(settings)));
  quietly(() => sessionStorage.setItem(TOKEN_KEY, token));
}
