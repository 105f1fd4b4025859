// The operator's limits as bars: how much of each is used.
import { make, say } from "./dom.js";
import { bytes, number } from "./words.js";

const percent = (value) => `${Math.round(100 * value)} %`;

const LIMITS = [
  ["connections", "Connections", number],
  ["unauthenticated", "Of these, without a hello", number],
  ["load", "Renderer's time asked for", percent],
  ["session_memory", "Memory promised to sessions", bytes],
  ["descriptors", "Open descriptors", number],
];

/** @returns {{share: number, text: string, level: string}} share: 0..1; level: for its color */
export function describe({ used, most }, format) {
  if (used === null) return { share: 0, text: "not known", level: "good" };
  if (!most) return { share: 0, text: `${format(used)}, no limit`, level: "good" };
  const share = Math.min(used / most, 1);
  const level = share >= 0.95 ? "error" : share >= 0.75 ? "warn" : "good";
  return { share, text: `${format(used)} of ${format(most)}`, level };
}

export class Limits {
  #bars;

  /** @param {HTMLElement} list */
  constructor(list) {
    this.#bars = LIMITS.map(([name, label, format]) => {
      const value = make("span", { class: "value" });
      const fill = make("div", { class: "fill" });
      const percents = { "aria-valuemin": "0", "aria-valuemax": "100" };
      const meter = { class: "bar", role: "meter", "aria-label": label, ...percents };
      const bar = make("div", meter, fill);
      const item = make("li", { id: `limit-${name}` }, make("span", { text: label }), bar, value);
      list.append(item);
      return { name, format, item, value, bar, fill };
    });
  }

  /** @param {Record<string, {used: number | null, most: number}>} limits of /state */
  update(limits) {
    for (const { name, format, item, value, bar, fill } of this.#bars) {
      const limit = limits[name];
      item.hidden = !limit;
      if (!limit) continue;
      const { share, text, level } = describe(limit, format);
      say(value, text);
      fill.style.width = `${100 * share}%`;
      bar.dataset.level = level;
      bar.setAttribute("aria-valuenow", Math.round(100 * share));
      bar.setAttribute("aria-valuetext", text);
    }
  }
}
