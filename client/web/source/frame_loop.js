// A frame's way through the page: captured, searched and encoded by the worker, sent, answered,
// shown. As many are under way at once as the pace allows; camera frames that find no room are
// skipped, because a newer one will come.
import { Pace } from "./pace.js";

const ANSWER_TIMEOUT_MS = 4000; // a frame that is not answered by then gives its room to another

/**
 * @typedef {object} Frame
 * @property {number} captured ms on performance.now()'s clock, as the others
 * @property {number} [sent]
 * @property {ImageBitmap} [picture] what was sent
 * @property {{marker: number, pixels: number[]}[]} [corners]
 * @property {{read: number, search: number, encode: number}} [times] ms
 * @property {boolean} [isAnswered] the listener has it, and its picture is the listener's
 */

export class FrameLoop {
  #worker;
  #session;
  #listener;
  #pace = new Pace();
  /** @type {Map<bigint, Frame>} */
  #underWay = new Map();
  #nextId = 1n;

  /**
   * @param {Worker} worker set up for the session's markers
   * @param {Session} session
   * @param {object} listener skipped(), lost(), found(corners), answered(composite, frame), which
   *   returns a promise of having shown it, and failed(text)
   */
  constructor(worker, session, listener) {
    this.#worker = worker;
    this.#session = session;
    this.#listener = listener;
    worker.onmessage = ({ data }) => this.#fromWorker(data);
  }

  get pace() {
    return this.#pace.limit;
  }

  /** Takes the video's current picture, if there is room for another frame. */
  async capture(video, captured) {
    this.#dropUnanswered();
    if (this.#underWay.size >= this.#pace.limit) {
      this.#listener.skipped();
      return;
    }
    const frameId = this.#nextId++;
    this.#underWay.set(frameId, { captured });
    try {
      const bitmap = await createImageBitmap(video);
      this.#worker.postMessage({ kind: "frame", frameId, bitmap }, [bitmap]);
    } catch {
      this.#underWay.delete(frameId); // the camera has just ended
    }
  }

  async composite(composite) {
    const frame = this.#underWay.get(composite.frameId);
    // Composites come in the order of their frames: older ones will not be answered any more.
    for (const id of [...this.#underWay.keys()]) {
      if (id < composite.frameId) this.#drop(id);
    }
    if (!frame) return;
    frame.isAnswered = true;
    try {
      await this.#listener.answered(composite, frame);
    } finally {
      this.#underWay.delete(composite.frameId);
    }
    const now = performance.now();
    this.#pace.shown(now - frame.captured, now);
  }

  /** The server will not answer this frame. */
  refused(frameId) {
    this.#drop(frameId);
  }

  stop() {
    this.#worker.onmessage = null;
    for (const id of [...this.#underWay.keys()]) this.#drop(id);
  }

  #fromWorker({ kind, frameId, jpeg, corners, picture, times, text }) {
    if (kind === "failed") {
      this.#drop(frameId);
      this.#listener.failed(text);
      return;
    }
    const frame = this.#underWay.get(frameId);
    if (!frame) {
      picture.close();
      return;
    }
    Object.assign(frame, { picture, corners, times, sent: performance.now() });
    this.#listener.found(corners);
    const captureTimeUs = BigInt(Math.max(0, Math.round(frame.captured * 1000)));
    const sent = this.#session.sendFrame({
      frameId,
      captureTimeUs,
      jpeg: new Uint8Array(jpeg),
      corners,
    });
    if (!sent) this.#drop(frameId);
  }

  #dropUnanswered() {
    const now = performance.now();
    for (const [id, { captured, isAnswered }] of [...this.#underWay]) {
      if (!isAnswered && now - captured > ANSWER_TIMEOUT_MS) {
        this.#drop(id);
        this.#listener.lost();
      }
    }
  }

  #drop(id) {
    const frame = this.#underWay.get(id);
    if (!frame?.isAnswered) frame?.picture?.close();
    this.#underWay.delete(id);
  }
}
