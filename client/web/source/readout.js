// The page's figures as tables: where a frame's time goes, what became of frames, which markers
// were used and what the server left out.

const UPDATE_MS = 500; // quicker than this nobody reads

const STAGES = [
  ["wait", "waiting for the camera"],
  ["read", "reading the picture"],
  ["search", "searching markers"],
  ["encode", "encoding"],
  ["network", "network, both ways"],
  ["server", "server"],
  ["decode", "decoding"],
  ["show", "showing"],
];

const ms = (value) => (Number.isNaN(value) ? "–" : `${value.toFixed(1)} ms`);

function row(...cells) {
  const tr = document.createElement("tr");
  cells.forEach((text, i) => {
    const cell = document.createElement(i === 0 ? "th" : "td");
    if (i === 0) cell.scope = "row";
    cell.textContent = text;
    tr.append(cell);
  });
  return tr;
}

export class Readout {
  #parts;
  #updated = -Infinity;

  /**
   * @param {Record<string, HTMLElement>} parts summary, and all, which holds the tables stages,
   *   frames and passes, and the list markers; it is hidden before there are figures
   */
  constructor(parts) {
    this.#parts = parts;
  }

  /**
   * @param {Figures} figures
   * @param {object} composite the newest one
   * @param {object} frame its frame
   * @param {number} underWay frames that may be under way at once
   */
  update(figures, composite, frame, underWay) {
    const now = performance.now();
    if (now - this.#updated < UPDATE_MS) return;
    this.#updated = now;
    this.#parts.all.hidden = false;
    const total = figures.average("total");
    const rate = figures.rate(now);
    this.#parts.summary.textContent = `${total.toFixed(0)} ms · ${rate.toFixed(1)} fps`;
    this.#stages(figures);
    this.#parts.frames.replaceChildren(
      row("shown", figures.shown),
      row("late, over 0.3 s old", figures.late),
      row("skipped by this page", figures.skipped),
      row("skipped by the server", composite.skipped),
      row("lost", figures.lost),
      row("under way at once", underWay),
    );
    this.#parts.markers.replaceChildren(...markerItems(composite.poses, frame.corners));
    this.#passes(composite);
  }

  #stages(figures) {
    const rows = STAGES.flatMap(([name, label]) => {
      const own = row(label, ms(figures.average(name)));
      if (name !== "server") return [own];
      const inner = figures.serverStages().filter(([, value]) => value >= 0.05);
      return [
        own,
        ...inner.map(([stage, value]) => {
          const tr = row(stage.replaceAll("_", " "), ms(value));
          tr.className = "inner";
          return tr;
        }),
      ];
    });
    const total = row("capture to screen", ms(figures.average("total")));
    total.className = "total";
    this.#parts.stages.replaceChildren(...rows, total);
  }

  #passes({ passes }) {
    const left = passes.filter(({ ran }) => !ran);
    this.#parts.passes.replaceChildren(
      ...left.map(({ name, reason }) => row(name.replaceAll("_", " "), reason)),
    );
    if (left.length === 0) this.#parts.passes.replaceChildren(row("nothing", ""));
  }
}

function markerItems(poses, corners) {
  const seen = new Set(corners.map(({ marker }) => marker));
  const items = poses.map(({ marker, translation }) => {
    const { x, y, z } = translation ?? { x: 0, y: 0, z: 0 };
    const item = document.createElement("li");
    const how = seen.has(marker) ? "in view" : "a moment ago";
    item.textContent = `marker ${marker}, ${Math.hypot(x, y, z).toFixed(2)} m away, ${how}`;
    return item;
  });
  if (items.length > 0) return items;
  const none = document.createElement("li");
  none.textContent = "none";
  return [none];
}
