// The page's parts connected: a camera, a session for its pictures, the frames between them, and
// what the page says about it.
import { fitToImage, parseCalibration } from "./calibration.js";
import { closeCamera, onEachFrame, openCamera } from "./camera.js";
import { cameraFromFieldOfView, sentSize } from "./camera_model.js";
import { Figures } from "./figures.js";
import { FrameLoop } from "./frame_loop.js";
import { parseSize } from "./settings.js";
import { sessionAddress } from "./server_address.js";
import { Session } from "./session.js";
import { cameraNotice, chip, noMarkerNotice, sessionNotice } from "./words.js";

const NO_MARKER_AFTER_MS = 800; // a marker is easily missed in single frames
const SMOOTHING = { minCutoff: 1, beta: 0 }; // what the native client's --smooth 1 is

export class App {
  #page;
  #settings;
  #session = null;
  #worker = null;
  #loop = null;
  #figures = new Figures();
  #markers = null; // of the server's Welcome
  #markerSeenAt = 0;
  #started = false;
  #lenses;
  #watcher = null; // who has the camera's pictures instead of a session

  /**
   * @param {object} page video, view, notice, readout, chip(words, kind), cameras(deviceId) and
   *   lens(camera), which is told the measured lens in use, or null
   * @param {object} settings of settings.js
   * @param {Lenses} lenses
   */
  constructor(page, settings, lenses) {
    this.#page = page;
    this.#settings = settings;
    this.#lenses = lenses;
    this.outlines = settings.markers;
    const { video } = page;
    onEachFrame(video, (captured) => this.#onVideo(captured));
    // A phone that is turned, for example: a session is for one size of pictures.
    video.addEventListener("resize", () => {
      if (this.#started && !this.#watcher) this.#openSession();
    });
    addEventListener("online", () => this.#session?.retryNow());
    addEventListener("pagehide", () => this.#session?.close());
  }

  /** Asks for the camera, and connects once there are pictures. */
  async start() {
    const { video, notice } = this.#page;
    this.#stop();
    notice.show({ level: "info", title: "Starting the camera", text: "The browser may ask you." });
    let stream;
    try {
      const { deviceId, size } = this.#settings;
      stream = await openCamera(video, { deviceId, ...parseSize(size) });
    } catch (error) {
      notice.show(cameraNotice(error.reason, error.message));
      return;
    }
    const [track] = stream.getVideoTracks();
    track.addEventListener("ended", () => {
      this.#stop();
      notice.show(cameraNotice("ended"));
    });
    this.#started = true;
    await this.#page.cameras(track.getSettings().deviceId);
    this.#openSession();
  }

  /** @param {object} settings of settings.js */
  apply(settings) {
    this.#settings = settings;
    this.start();
  }

  retryNow() {
    this.#session?.retryNow();
  }

  /**
   * Gives the camera's pictures to somebody else, and ends the session.
   * @param {{frame: (video: HTMLVideoElement) => void, ended: () => void}} watcher
   * @returns {Promise<boolean>} whether there is a camera
   */
  async lend(watcher) {
    if (!this.#started) await this.start();
    if (!this.#started) return false;
    this.#closeSession();
    this.#page.notice.show(null);
    this.#page.chip("measuring the lens", "closed");
    this.#watcher = watcher;
    return true;
  }

  takeBack() {
    this.#watcher = null;
    if (this.#started) this.#openSession();
  }

  /** From now on the lens of this camera, for pictures of this size, instead of a file. */
  keepLens(lens, width, height) {
    this.#settings = { ...this.#settings, calibration: null };
    this.#lenses.keep(this.#deviceId, width, height, lens);
  }

  forgetLens() {
    const { width, height } = this.#size;
    this.#lenses.forget(this.#deviceId, width, height);
    if (this.#started) this.#openSession();
  }

  #stop() {
    this.#started = false;
    this.#closeSession();
    this.#watcher?.ended();
    this.#watcher = null;
    closeCamera(this.#page.video);
  }

  get #deviceId() {
    return this.#page.video.srcObject?.getVideoTracks()[0]?.getSettings().deviceId ?? "";
  }

  get #size() {
    return sentSize(this.#page.video.videoWidth, this.#page.video.videoHeight);
  }

  // A chosen file comes first, then a measured lens.
  #camera() {
    const { width, height } = this.#size;
    const { calibration, fieldOfView } = this.#settings;
    const lens = calibration ? null : this.#lenses.find(this.#deviceId, width, height);
    const text = calibration?.text ?? lens?.text;
    const camera = text
      ? fitToImage(parseCalibration(text), width, height)
      : cameraFromFieldOfView(fieldOfView, width, height);
    this.#page.lens(lens ? { camera, error: lens.error } : null);
    return camera;
  }

  #closeSession() {
    this.#endLoop();
    this.#session?.close();
    this.#session = null;
  }

  #openSession() {
    this.#closeSession();
    const { server, token, steady } = this.#settings;
    try {
      const camera = this.#camera();
      const hello = { token, camera, jpegQuality: 0, ...(steady && { smoothing: SMOOTHING }) };
      const session = new Session(sessionAddress(server, location), hello, {
        status: (status) => this.#onStatus(status, camera),
        composite: (composite) => this.#loop?.composite(composite),
        error: (error) => this.#onFrameError(error),
      });
      this.#session = session;
      session.open();
    } catch (error) {
      const { message: text } = error;
      this.#page.notice.show({
        level: "error",
        title: "These settings do not work",
        text,
        action: "settings",
      });
    }
  }

  #onStatus(status, camera) {
    this.#page.chip(chip(status), status.kind);
    if (status.kind === "closed") return;
    if (status.kind === "ready") this.#beginLoop(status.markers, camera);
    else this.#endLoop();
    this.#page.notice.show(sessionNotice(status), status.retryAt);
  }

  #beginLoop(markers, { width, height }) {
    const { dictionary, ids } = markers;
    const { quality } = this.#settings;
    this.#markers = markers;
    this.#markerSeenAt = performance.now();
    this.#worker = new Worker("worker.js", { type: "module" });
    this.#worker.postMessage({ kind: "setup", dictionary, ids, width, height, quality });
    this.#loop = new FrameLoop(this.#worker, this.#session, {
      skipped: () => ++this.#figures.skipped,
      lost: () => ++this.#figures.lost,
      found: (corners) => this.#onFound(corners),
      answered: (composite, frame) => this.#show(composite, frame),
      failed: (text) => {
        this.#page.notice.show({ level: "error", title: "Markers cannot be searched", text });
      },
    });
  }

  #endLoop() {
    this.#loop?.stop();
    this.#worker?.terminate();
    this.#loop = null;
    this.#worker = null;
  }

  #onVideo(captured) {
    if (!this.#started) return;
    if (this.#watcher) this.#watcher.frame(this.#page.video);
    else if (this.#loop) this.#loop.capture(this.#page.video, captured);
    else this.#page.view.showVideo(this.#page.video);
  }

  #onFound(corners) {
    const now = performance.now();
    if (corners.length > 0) this.#markerSeenAt = now;
    const missing = now - this.#markerSeenAt > NO_MARKER_AFTER_MS;
    this.#page.notice.show(missing ? noMarkerNotice(this.#markers) : null);
  }

  #onFrameError({ code, text, frameId }) {
    console.warn(`frame ${frameId}: ${code}: ${text}`);
    // A frame with an unusable pose is answered all the same.
    if (code !== "POSE_REJECTED") this.#loop?.refused(frameId);
  }

  async #show(composite, frame) {
    const received = performance.now();
    const { picture } = frame;
    const loop = this.#loop;
    const bitmap = composite.unchanged
      ? picture
      : await createImageBitmap(new Blob([composite.jpeg], { type: "image/jpeg" }));
    const decoded = performance.now();
    if (this.#loop !== loop) {
      // Ended meanwhile, and perhaps another one has begun.
      picture.close();
      bitmap.close();
      return;
    }
    const { view, readout } = this.#page;
    view.show({ composite: bitmap, picture });
    const used = new Set(composite.poses.map(({ marker }) => marker));
    view.outline(this.outlines ? frame.corners.filter(({ marker }) => used.has(marker)) : []);
    const shown = performance.now();
    this.#figures.add(composite, frame, { received, decoded, shown });
    readout.update(this.#figures, composite, frame, this.#loop.pace);
  }
}
