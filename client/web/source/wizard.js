// Measures the camera's lens: asks for views of the board, shows which parts of the picture they
// have covered, and offers the lens that follows from them.
import { fieldOfView, sentSize } from "./camera_model.js";
import limits from "./lens/limits.json";
import { toYaml } from "./lens/opencv_yaml.js";
import { lensWords, viewWords } from "./lens/words.js";
import { saveFile } from "./recorder.js";

const FIRST_WORDS = "Waiting for the board.";

export class Wizard {
  #parts;
  #view;
  #actions;
  #worker = null;
  #busy = false; // a picture is being looked at
  #solving = false;
  #size = { width: 0, height: 0 };
  #corners = [];
  #lens = null; // {camera, error, tilt} once it is known

  /**
   * @param {Record<string, HTMLElement>} parts card, state, error, coverage, and the buttons finish,
   *   use, save, again and cancel
   * @param {CompositeView} view
   * @param {object} actions lend(watcher), which returns a promise of whether there is a camera;
   *   takeBack(); use({text, error}, width, height)
   */
  constructor(parts, view, actions) {
    this.#parts = parts;
    this.#view = view;
    this.#actions = actions;
    const { coverage, finish, use, save, again, cancel } = parts;
    const cells = Array.from({ length: limits.cells ** 2 }, () => document.createElement("span"));
    coverage.style.setProperty("--cells", limits.cells);
    coverage.replaceChildren(...cells);
    finish.addEventListener("click", () => this.#solve());
    use.addEventListener("click", () => this.#use());
    save.addEventListener("click", () => this.#save());
    again.addEventListener("click", () => this.#begin());
    cancel.addEventListener("click", () => this.close());
  }

  /** Takes the camera, and shows itself if there is one. */
  async open() {
    const watcher = { frame: (video) => this.#onVideo(video), ended: () => this.#hide() };
    if (!(await this.#actions.lend(watcher))) return;
    this.#size = { width: 0, height: 0 };
    this.#parts.card.hidden = false;
    this.#parts.coverage.hidden = false;
    this.#parts.cancel.focus();
  }

  close() {
    this.#hide();
    this.#actions.takeBack();
  }

  #hide() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#parts.card.hidden = true;
    this.#parts.coverage.hidden = true;
  }

  #begin() {
    this.#worker?.terminate();
    this.#worker = new Worker("lens_worker.js", { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#fromWorker(data);
    this.#worker.postMessage({ kind: "setup", ...this.#size });
    this.#busy = false;
    this.#solving = false;
    this.#corners = [];
    this.#lens = null;
    this.#parts.error.textContent = "";
    this.#say(FIRST_WORDS, { finish: false });
    for (const cell of this.#parts.coverage.children) cell.classList.remove("seen");
  }

  async #onVideo(video) {
    this.#view.showVideo(video);
    this.#view.outline(this.#corners);
    const { width, height } = sentSize(video.videoWidth, video.videoHeight);
    if (width !== this.#size.width || height !== this.#size.height) {
      this.#size = { width, height };
      this.#begin();
    }
    if (this.#busy || this.#solving || this.#lens) return;
    this.#busy = true;
    const worker = this.#worker;
    try {
      const bitmap = await createImageBitmap(video);
      worker.postMessage({ kind: "frame", bitmap }, [bitmap]);
    } catch {
      this.#busy = false; // the camera has just ended
    }
  }

  #fromWorker(message) {
    this.#busy = false;
    if (message.kind === "view") {
      if (!this.#solving) this.#onView(message);
      return;
    }
    this.#solving = false;
    if (message.kind === "lens") this.#onLens(message);
    else this.#onRefused(message);
  }

  #onView(view) {
    // Outlines have the canvas's pixels, which are the video's.
    const { width } = this.#view.canvas;
    const scale = width / this.#size.width;
    this.#corners = view.corners.map(({ marker, pixels }) => ({
      marker,
      pixels: pixels.map((value) => (value + 0.5) * scale - 0.5),
    }));
    [...this.#parts.coverage.children].forEach((cell, i) =>
      cell.classList.toggle("seen", view.seen[i]),
    );
    if (view.offer === "taken") this.#parts.error.textContent = "";
    this.#say(viewWords(view), { finish: view.views >= limits.fewestViews });
    if (view.isEnough && this.#parts.error.textContent === "") this.#solve();
  }

  #solve() {
    this.#solving = true;
    this.#worker.postMessage({ kind: "solve" });
    this.#say("Solving for the lens …", { finish: false });
  }

  #onLens(lens) {
    this.#lens = lens;
    this.#corners = [];
    this.#say(lensWords(lens, fieldOfView(lens.camera)), { solved: true });
    this.#parts.use.focus();
  }

  #onRefused({ text }) {
    this.#parts.error.textContent = text;
    this.#say("More views may help, or start over.", { finish: true });
  }

  #say(words, { finish = false, solved = false }) {
    const { state, finish: button, use, save } = this.#parts;
    if (state.textContent !== words) state.textContent = words;
    button.disabled = !finish;
    button.hidden = solved;
    use.hidden = !solved;
    save.hidden = !solved;
  }

  get #text() {
    return toYaml(this.#lens.camera, this.#lens.error);
  }

  #use() {
    const { width, height } = this.#size;
    this.#actions.use({ text: this.#text, error: this.#lens.error }, width, height);
    this.close();
  }

  #save() {
    const { width, height } = this.#size;
    saveFile(new Blob([this.#text], { type: "application/yaml" }), `lens-${width}x${height}.yml`);
  }
}
