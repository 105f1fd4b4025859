// The buttons and the slider below the picture, and the keys that do the same.
import { FilmRecorder, saveSnapshot } from "./recorder.js";

const element = (id) => document.getElementById(id);

const press = (button, pressed) => button.setAttribute("aria-pressed", String(pressed));

// Keys that a control uses itself: letters where one types or chooses, arrows on sliders too.
const takesLetters = ({ target }) =>
  target.closest("select, input:not([type=range], [type=checkbox])") !== null;
const takesArrows = ({ target }) => target.closest("select, input") !== null;

/**
 * @param {CompositeView} view
 * @param {{markers: boolean}} settings
 * @param {(markers: boolean) => void} onMarkers told when outlines are switched
 */
export function connectControls(view, settings, onMarkers) {
  const film = new FilmRecorder();
  const compare = element("compare");
  const showShare = () => {
    view.setCameraShare(compare.value / 100);
    compare.setAttribute("aria-valuetext", `${compare.value} % camera`);
  };
  compare.addEventListener("input", showShare);
  showShare();

  const move = (by) => {
    compare.value = Number(compare.value) + by;
    showShare();
  };
  let markers = settings.markers;
  const showMarkers = () => {
    press(element("markers-button"), markers);
    onMarkers(markers);
  };
  showMarkers();

  const actions = {
    "markers-button": () => {
      markers = !markers;
      showMarkers();
    },
    "snapshot-button": () => saveSnapshot(view.canvas),
    "film-button": () => {
      if (film.isRecording) film.stop();
      else film.start(view.canvas);
      press(element("film-button"), film.isRecording);
    },
    "screen-button": () => {
      if (document.fullscreenElement) document.exitFullscreen();
      else element("stage").requestFullscreen?.();
    },
    "panel-button": () => togglePanel(),
  };
  for (const [id, action] of Object.entries(actions)) element(id).addEventListener("click", action);
  // What the browser cannot do is not offered.
  element("film-button").hidden = !FilmRecorder.isSupported;
  element("screen-button").hidden = !document.fullscreenEnabled;

  const keys = { m: "markers-button", s: "snapshot-button", r: "film-button", f: "screen-button" };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || takesLetters(event)) return;
    const key = event.key.toLowerCase();
    if (key.startsWith("arrow")) {
      if (key === "arrowleft" && !takesArrows(event)) move(-5);
      if (key === "arrowright" && !takesArrows(event)) move(5);
    } else if (key === "p") togglePanel();
    else if (keys[key] && !element(keys[key]).hidden) actions[keys[key]]();
  });
}

/** @param {boolean} [open] without it: the other way round */
export function togglePanel(open = element("panel").hidden) {
  element("panel").hidden = !open;
  element("panel-button").setAttribute("aria-expanded", String(open));
}
