// The page begins here: its elements are found and connected.
import { App } from "./app.js";
import { CompositeView } from "./composite_view.js";
import { connectControls, togglePanel } from "./controls.js";
import { Lenses, localStorageOrNone } from "./lenses.js";
import { Notice } from "./notice.js";
import { Readout } from "./readout.js";
import { loadSettings, saveSettings } from "./settings.js";
import { SettingsForm } from "./settings_form.js";
import { hasSheet, showSheets } from "./sheets.js";
import { Wizard } from "./wizard.js";

const element = (id) => document.getElementById(id);

let settings = loadSettings();
const keep = (changed) => {
  settings = { ...settings, ...changed };
  saveSettings(settings);
};

const view = new CompositeView(element("canvas"), element("outlines"), element("line"));
const notice = new Notice(
  {
    card: element("notice"),
    title: element("notice-title"),
    text: element("notice-text"),
    countdown: element("notice-countdown"),
    action: element("notice-action"),
  },
  {
    start: () => app.start(),
    retry: () => app.retryNow(),
    settings: () => {
      togglePanel(true);
      element("token").focus();
    },
  },
);
const readout = new Readout({
  all: element("figures"),
  summary: element("summary"),
  stages: element("stages"),
  frames: element("frames"),
  markers: element("markers-used"),
  passes: element("passes"),
});
const form = new SettingsForm(settings, (changed) => {
  keep(changed);
  app.apply(settings);
});

const page = {
  video: element("video"),
  view,
  notice,
  readout,
  chip: (words, kind) => {
    element("chip").textContent = words;
    element("chip").dataset.kind = kind;
  },
  cameras: async (deviceId) => {
    element("picture").classList.add("started");
    await form.listCameras(deviceId);
  },
  lens: (lens) => form.showLens(lens),
};
const app = new App(page, settings, new Lenses(localStorageOrNone()));
connectControls(view, settings, (markers) => {
  app.outlines = markers;
  keep({ markers });
});

const wizardParts = ["state", "error", "finish", "use", "save", "again", "cancel"].map((name) => [
  name,
  element(`wizard-${name}`),
]);
const wizard = new Wizard(
  { ...Object.fromEntries(wizardParts), card: element("wizard"), coverage: element("coverage") },
  view,
  {
    lend: (watcher) => app.lend(watcher),
    takeBack: () => app.takeBack(),
    use: (lens, width, height) => {
      form.forgetFile(); // or it would come first
      keep({ calibration: null });
      app.keepLens(lens, width, height);
    },
  },
);
element("lens-measure").addEventListener("click", () => {
  togglePanel(false); // on phones it would leave no room for the picture
  wizard.open();
  offerSheets(".board-sheets", "lens-board.pdf");
});
element("lens-forget").addEventListener("click", () => app.forgetLens());

// Sheets are of the scene of the page's own server.
async function offerSheets(selector, file) {
  if (settings.server === "" && (await hasSheet(file))) {
    showSheets(document.querySelectorAll(selector), file);
  }
}
offerSheets(".marker-sheets", "marker-sheet.pdf");
