// A server of the page's files and of scripted sessions, in place of an amalgam-server: it can be
// full, end, or answer in ways that a real one only rarely does.
import { createReadStream } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { WebSocketServer } from "ws";
import { decode, encode } from "amalgam-page/wire.js";

// What the real server makes to print.
const SHEETS = ["/marker-sheet.pdf", "/lens-board.pdf"];

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
};

// As the real server's: what it forbids must fail here too.
const POLICY =
  "default-src 'self'; worker-src 'self' blob:; img-src 'self' blob: data:; " +
  "connect-src 'self' ws: wss:; media-src 'self' blob:";

export const WELCOME = {
  session: 1n,
  limits: { maxMessageBytes: 4194304, maxPoses: 64, pingIntervalMs: 1000, idleTimeoutMs: 5000 },
  markers: { dictionary: "DICT_6X6_250", length: 0.05, worldMarker: 40, ids: [40] },
};

/** @returns {object} fields of a Composite that gives a frame back as it was sent */
export function unchanged({ frameId, captureTimeUs, jpeg }) {
  const stages = [{ name: "decode", milliseconds: 1.5 }];
  const passes = [{ name: "trace", ran: false, reason: "nothing specular in view" }];
  return { frameId, captureTimeUs, jpeg, unchanged: true, serverMs: 2, stages, passes };
}

export class StubServer {
  /** Messages that were received, in their order. */
  received = [];
  /** Whether there are sheets to print. */
  prints = true;
  #http;
  #sockets;

  /**
   * @param {string} folder the page's files
   * @param {Record<string, (value: object, send: Function, socket: object) => void>} answers by
   *   the kind of message; they may be exchanged at any time
   */
  constructor(folder, answers) {
    this.answers = answers;
    this.#http = createServer((request, response) => {
      const path = normalize(request.url === "/" ? "/index.html" : request.url.split("?")[0]);
      if (SHEETS.includes(path)) {
        response.writeHead(this.prints ? 200 : 404, { "Content-Type": "application/pdf" }).end();
        return;
      }
      const type = TYPES[extname(path)] ?? "application/octet-stream";
      const file = createReadStream(join(folder, path));
      file.on("error", () => response.writeHead(404).end());
      file.once("open", () => {
        response.writeHead(200, { "Content-Type": type, "Content-Security-Policy": POLICY });
        file.pipe(response);
      });
    });
    this.#sockets = new WebSocketServer({ server: this.#http, path: "/session" });
    this.#sockets.on("connection", (socket) => {
      const send = (kind, value) => socket.send(encode(kind, value));
      socket.on("message", (data) => {
        const { case: kind, value } = decode(new Uint8Array(data));
        this.received.push({ kind, value });
        this.answers[kind]?.(value, send, socket);
      });
    });
  }

  /** @returns {Promise<string>} the page's address */
  async listen(port = 0) {
    await new Promise((resolve) => this.#http.listen(port, "127.0.0.1", resolve));
    return `http://127.0.0.1:${this.#http.address().port}/`;
  }

  get port() {
    return this.#http.address().port;
  }

  /** Closes the sessions, and lets nobody in any more. */
  async close() {
    for (const socket of this.#sockets.clients) socket.terminate();
    this.#http.closeAllConnections();
    await new Promise((resolve) => this.#http.close(resolve));
  }
}
