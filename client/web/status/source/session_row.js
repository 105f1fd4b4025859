// One session: a row of the table, and below it, when it is opened, what its frames went through.
import { make, say } from "./dom.js";
import { SessionDetails } from "./session_details.js";
import { bytes, duration, number } from "./words.js";

/** Head and text of each column; the first and the picture are made by the row itself. */
export const COLUMNS = [
  ["Address", ({ peer, transport }) => `${peer} · ${transport}`],
  ["Size", ({ width, height }) => (width ? `${width} × ${height}` : "–")],
  ["Age", ({ age_s: age }) => duration(age)],
  ["Asks, fps", ({ frames_asked_per_second: rate }) => number(rate)],
  ["Gets, fps", ({ frames_served_per_second: rate }) => number(rate)],
  ["Median, ms", ({ server_ms_median: time }) => number(time)],
  ["99 %, ms", ({ server_ms_p99: time }) => number(time)],
  ["Received", ({ bytes_received: size }) => bytes(size)],
  ["Sent", ({ bytes_sent: size }) => bytes(size)],
  ["Skipped", ({ frames_skipped: count }) => `${count}`],
];

export class SessionRow {
  row;
  details;
  #state = make("small");
  #button;
  #image = make("img", { loading: "lazy", decoding: "async", width: "96", height: "72" });
  #picture;
  #cells;
  #more;
  #last = null;

  /** @param {number} id */
  constructor(id) {
    const opens = { type: "button", "aria-expanded": "false", "aria-controls": `session-${id}` };
    this.#button = make("button", { ...opens, text: `Session ${id}` });
    this.#button.addEventListener("click", () => this.#toggle());
    this.#image.alt = `Last composite of session ${id}`;
    // Not hidden: what is, is never loaded.
    this.#image.addEventListener("error", () => this.#image.classList.add("missing"));
    this.#image.addEventListener("load", () => this.#image.classList.remove("missing"));
    this.#picture = make("td", { role: "cell", class: "picture" }, this.#image);
    this.#cells = COLUMNS.map(([head]) => make("td", { role: "cell", "data-label": head }));
    const first = make("th", { role: "rowheader", scope: "row" }, this.#button, this.#state);
    this.row = make("tr", { role: "row" }, first, this.#picture, ...this.#cells);
    this.#more = new SessionDetails();
    const wide = { role: "cell", colspan: String(COLUMNS.length + 2) };
    const cell = make("td", wide, this.#more.element);
    this.details = make("tr", { id: `session-${id}`, role: "row", class: "details" }, cell);
    this.details.hidden = true;
  }

  /**
   * @param {object} session of /state
   * @param {boolean} pictures whether there is a column for them
   */
  update(session, pictures) {
    this.#last = session;
    COLUMNS.forEach(([, text], i) => say(this.#cells[i], text(session)));
    say(this.#state, session.state === "running" ? "" : session.state.replaceAll("_", " "));
    this.#picture.hidden = !pictures;
    this.#image.hidden = !session.picture;
    if (session.picture) this.#showPicture(session);
    if (!this.details.hidden) this.#more.update(session);
  }

  #toggle() {
    this.details.hidden = !this.details.hidden;
    this.#button.setAttribute("aria-expanded", String(!this.details.hidden));
    if (this.#last && !this.details.hidden) this.#more.update(this.#last);
  }

  // Another address for each frame, because the browser would show what it has.
  #showPicture({ id, frames_sent: frame }) {
    const address = `pictures/${id}.jpg?${frame}`;
    if (this.#image.getAttribute("src") !== address) this.#image.src = address;
  }
}
