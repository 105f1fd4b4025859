// What a session's last frame went through, pass by pass, and why frames were skipped.
import { make } from "./dom.js";
import { number, plain, plural, skips } from "./words.js";

const row = (...texts) =>
  make("tr", {}, ...texts.map((text, i) => make(i === 0 ? "th" : "td", { text })));

const table = (title, heads, rows) =>
  make(
    "table",
    {},
    make("caption", { text: title }),
    make("thead", {}, make("tr", {}, ...heads.map((text) => make("th", { scope: "col", text })))),
    make("tbody", {}, ...rows),
  );

export class SessionDetails {
  element = make("div", { class: "session-details" });
  #shown = "";

  /** @param {object} session of /state */
  update(session) {
    const { passes, stages_ms: stages, skipped_by: skipped, quality } = session;
    const shown = JSON.stringify([passes, stages, skipped, quality, session.frames_unchanged]);
    if (shown === this.#shown) return;
    this.#shown = shown;
    const parts = [ranTable(passes, stages), leftOutTable(passes), framesTable(session)];
    this.element.replaceChildren(...parts);
  }
}

function ranTable(passes, stages) {
  const rows = passes
    .filter(({ ran }) => ran)
    .map(({ name }) => {
      const time = stages[name] ?? stages[name.replaceAll(" ", "_")];
      return row(plain(name), number(time));
    });
  return table("Run for the last frame", ["pass", "ms"], rows.length ? rows : [row("nothing")]);
}

function leftOutTable(passes) {
  const rows = passes.filter(({ ran }) => !ran).map(({ name, reason }) => row(plain(name), reason));
  return table("Left out", ["pass", "why"], rows.length ? rows : [row("nothing")]);
}

function framesTable({ skipped_by: skipped, frames_unchanged: unchanged, quality, ...session }) {
  const rows = skips(skipped).map(([reason, count]) => row(reason, String(count)));
  rows.push(row("sent back unchanged: nothing virtual in view", String(unchanged)));
  rows.push(row("under way", String(session.frames_in_flight)));
  if (quality) {
    const { level, lowest_level: lowest, bound } = quality;
    rows.push(row("quality", `${plural(level, "level")} of ${lowest} down; bound: ${bound}`));
  }
  if (session.own_environment) rows.push(row("light", "of its own"));
  return table("Frames", ["what became of them", "number"], rows);
}
