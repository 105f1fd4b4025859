// The conversation with a server: hello, frames and composites, pings, and what to do when the
// connection ends. It knows nothing of cameras or of the page.
import { backoffMs, busyMs } from "./backoff.js";
import { decode, encode, errorName, PROTOCOL_VERSION } from "./wire.js";

/**
 * What a session tells. A status is one of
 *   {kind: "connecting"}
 *   {kind: "ready", markers, limits}
 *   {kind: "draining"}                       the server is about to end
 *   {kind: "busy", reason, retryAt}          the server is full
 *   {kind: "lost", reason, retryAt}          the connection failed or ended
 *   {kind: "refused", code, text}            trying again would change nothing
 *   {kind: "closed"}                         by close()
 * retryAt is of Date.now(); then the session connects again by itself.
 * @typedef {object} Listener
 * @property {(status: object) => void} status
 * @property {(composite: object) => void} composite
 * @property {(error: {code: string, text: string, frameId: bigint}) => void} error of one frame
 */

// After these a new attempt with the same Hello would end in the same way.
const FINAL = new Set(["UNSUPPORTED_VERSION", "AUTH_FAILED", "BAD_HELLO", "PROTOCOL_ERROR"]);
// A server that never answers at all: as long as its own patience with a Hello, and some way.
const WELCOME_TIMEOUT_MS = 8000;

export class Session {
  #address;
  #hello;
  #listener;
  #tools;
  #socket = null;
  #timer = null;
  #watchdog = null;
  #attempt = 0;
  #idleMs = WELCOME_TIMEOUT_MS;
  #status = { kind: "closed" };

  /**
   * @param {string} address ws:// or wss://
   * @param {object} hello fields of Hello, without the version
   * @param {Listener} listener
   * @param {object} tools WebSocket, setTimeout, clearTimeout, now, random: tests bring their own
   */
  constructor(address, hello, listener, tools = {}) {
    this.#address = address;
    this.#hello = hello;
    this.#listener = listener;
    this.#tools = {
      WebSocket: globalThis.WebSocket,
      setTimeout: (f, ms) => setTimeout(f, ms),
      clearTimeout: (timer) => clearTimeout(timer),
      now: () => Date.now(),
      random: Math.random,
      ...tools,
    };
  }

  get status() {
    return this.#status;
  }

  open() {
    this.#forget();
    this.#idleMs = WELCOME_TIMEOUT_MS;
    this.#tell({ kind: "connecting" });
    const socket = new this.#tools.WebSocket(this.#address);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    // A socket that was given up may still have something to say.
    const current = (f) => (event) => this.#socket === socket && f(event);
    socket.onopen = current(() =>
      this.#send("hello", { ...this.#hello, version: PROTOCOL_VERSION }),
    );
    socket.onmessage = current((event) => this.#receive(event.data));
    socket.onclose = current((event) => this.#ended(event.reason));
    this.#feedWatchdog();
  }

  /** Tells the server goodbye and stays closed. */
  close() {
    if (this.#socket?.readyState === this.#tools.WebSocket.OPEN) this.#send("goodbye", {});
    this.#forget();
    this.#tell({ kind: "closed" });
  }

  /** Connects now instead of at retryAt. */
  retryNow() {
    if (this.#timer !== null) this.open();
  }

  /**
   * @param {{frameId: bigint, captureTimeUs: bigint, jpeg: Uint8Array, corners: object[]}} frame
   * @returns {boolean} whether it was sent
   */
  sendFrame(frame) {
    if (this.#status.kind !== "ready") return false;
    this.#send("cameraFrame", frame);
    return true;
  }

  /** Bytes that the browser has not yet given to the network. */
  get unsent() {
    return this.#socket?.bufferedAmount ?? 0;
  }

  #send(kind, value) {
    this.#socket.send(encode(kind, value));
  }

  #receive(data) {
    this.#feedWatchdog();
    let message;
    try {
      message = decode(data);
    } catch (error) {
      this.#lost(`the server sent something that is no message (${error.message})`);
      return;
    }
    const handlers = {
      welcome: (welcome) => this.#welcome(welcome),
      composite: (composite) => this.#listener.composite(composite),
      ping: ({ nonce }) => this.#send("pong", { nonce }),
      pong: () => {},
      busy: (busy) => this.#busy(busy),
      error: (error) => this.#error(error),
      draining: () => this.#tell({ kind: "draining" }),
    };
    handlers[message.case]?.(message.value);
  }

  #welcome({ markers, limits }) {
    this.#attempt = 0;
    if (limits?.idleTimeoutMs) this.#idleMs = limits.idleTimeoutMs;
    this.#feedWatchdog();
    this.#tell({ kind: "ready", markers, limits });
  }

  #busy({ retryAfterMs, reason }) {
    this.#forget();
    this.#waitAndOpen(busyMs(retryAfterMs, this.#tools.random), { kind: "busy", reason });
  }

  #error({ code, text, frameId, closes }) {
    const name = errorName(code);
    if (!closes) {
      this.#listener.error({ code: name, text, frameId });
    } else if (FINAL.has(name)) {
      this.#forget();
      this.#tell({ kind: "refused", code: name, text });
    } else {
      this.#lost(text || name);
    }
  }

  #ended(reason) {
    const drained = this.#status.kind === "draining";
    this.#lost(drained ? "the server has ended" : reason || "the connection ended");
  }

  #lost(reason) {
    this.#forget();
    const wait = backoffMs(this.#attempt++, this.#tools.random);
    this.#waitAndOpen(wait, { kind: "lost", reason });
  }

  #waitAndOpen(ms, status) {
    this.#timer = this.#tools.setTimeout(() => this.open(), ms);
    this.#tell({ ...status, retryAt: this.#tools.now() + ms });
  }

  // The server pings each second, so silence means that it or the way to it is gone. A WebSocket
  // itself may take minutes to notice.
  #feedWatchdog() {
    this.#tools.clearTimeout(this.#watchdog);
    this.#watchdog = this.#tools.setTimeout(
      () => this.#lost("nothing was heard from the server"),
      this.#idleMs,
    );
  }

  // Ends the socket and all timers; what they still say is ignored.
  #forget() {
    this.#tools.clearTimeout(this.#timer);
    this.#tools.clearTimeout(this.#watchdog);
    this.#timer = null;
    const socket = this.#socket;
    this.#socket = null;
    socket?.close();
  }

  #tell(status) {
    this.#status = status;
    this.#listener.status(status);
  }
}
