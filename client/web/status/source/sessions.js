// The table of sessions. Rows stay while their session does, so that what is opened stays open and
// what has the focus keeps it.
import { make, say } from "./dom.js";
import { COLUMNS, SessionRow } from "./session_row.js";
import { plural } from "./words.js";

export class Sessions {
  #parts;
  #body = make("tbody", { role: "rowgroup" });
  #pictureHead;
  #rows = new Map(); // id -> SessionRow

  /** @param {Record<"table" | "title" | "none" | "hint", HTMLElement>} parts */
  constructor(parts) {
    this.#parts = parts;
    const head = (text) => make("th", { role: "columnheader", scope: "col", text });
    this.#pictureHead = head("Picture");
    const heads = COLUMNS.map(([text]) => head(text));
    const row = make("tr", { role: "row" }, head("Session"), this.#pictureHead, ...heads);
    parts.table.append(make("thead", { role: "rowgroup" }, row), this.#body);
  }

  /** @param {object} state of /state */
  update({ sessions, admin_pictures: pictures }) {
    const { table, title, none, hint } = this.#parts;
    say(title, sessions.length ? plural(sessions.length, "session") : "Sessions");
    say(
      hint,
      pictures
        ? "The last composite of each is shown (--admin-pictures), to whoever reaches this page."
        : "Their pictures are not shown: that takes the server's option --admin-pictures.",
    );
    table.hidden = sessions.length === 0;
    none.hidden = sessions.length > 0;
    const shown = sessions.some(({ picture }) => picture);
    this.#pictureHead.hidden = !shown;
    const there = new Set(sessions.map(({ id }) => id));
    for (const [id, { row, details }] of this.#rows) {
      if (there.has(id)) continue;
      row.remove();
      details.remove();
      this.#rows.delete(id);
    }
    for (const session of sessions) this.#rowOf(session.id).update(session, shown);
  }

  #rowOf(id) {
    const known = this.#rows.get(id);
    if (known) return known;
    const made = new SessionRow(id); // the server lists them by their number
    this.#rows.set(id, made);
    this.#body.append(made.row, made.details);
    return made;
  }
}
