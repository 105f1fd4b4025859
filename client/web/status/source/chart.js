// One chart, drawn by uPlot, with its newest values as text beside it.
import uPlot from "uplot";
import { stacked } from "./chart_data.js";
import { make, say } from "./dom.js";
import { SPAN_S } from "./history.js";
import { number } from "./words.js";

const HEIGHT = 170; // px
const CLOCK = { hour: "2-digit", minute: "2-digit", hourCycle: "h23" };
const FONT = "12px system-ui, sans-serif";

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const color = (line) => style(`--chart-${line + 1}`);
const clock = (seconds) =>
  new Date(1000 * seconds).toLocaleTimeString([], CLOCK);

export class Chart {
  element;
  #spec;
  #plotted = null; // uPlot
  #labels = "";
  #box;
  #legend;
  #lines = [];
  #now = 0;
  #least = 0;

  /** @param {object} spec of chart_data.js */
  constructor(spec) {
    this.#spec = spec;
    const title = make("h3", { text: spec.title }, make("small", { text: ` ${spec.unit}` }));
    const words = `${spec.title} over the last five minutes; the newest values are listed here.`;
    this.#box = make("div", { class: "plot", role: "img", "aria-label": words });
    this.#legend = make("ul", { class: "legend" });
    this.element = make("figure", { id: `chart-${spec.id}` });
    this.element.append(make("figcaption", {}, title, this.#legend), this.#box);
    new ResizeObserver(() => this.#resize()).observe(this.#box);
  }

  /** @param {number} now s */
  update(history, state, now) {
    this.#now = now;
    this.#least = this.#spec.least(state);
    this.#lines = this.#spec.lines(history);
    const labels = this.#lines.map(({ label }) => label).join("\n");
    const values = this.#spec.stacked
      ? stacked(this.#lines)
      : this.#lines.map((line) => line.values);
    const data = [history.times, ...values];
    if (labels !== this.#labels) this.#rebuild(labels, data);
    else this.#plotted?.setData(data);
    this.#say(this.#plotted?.cursor.idx);
  }

  /** The colors have changed. */
  repaint() {
    if (this.#plotted) this.#rebuild(this.#labels, this.#plotted.data);
  }

  #rebuild(labels, data) {
    this.#labels = labels;
    this.#plotted?.destroy();
    this.#plotted = this.#lines.length ? new uPlot(this.#options(), data, this.#box) : null;
    const entries = this.#lines.map(({ label }, line) => {
      const swatch = make("span", { class: "swatch", "aria-hidden": "true" });
      swatch.style.background = color(line);
      return make("li", {}, swatch, make("span", { text: label }), make("output"));
    });
    this.#legend.replaceChildren(...entries);
  }

  // What is under the pointer, or the newest.
  #say(index) {
    this.#lines.forEach(({ values }, line) => {
      const value = values[index ?? values.length - 1];
      say(this.#legend.children[line].lastChild, number(value));
    });
  }

  #resize() {
    const width = this.#box.clientWidth;
    if (width > 0) this.#plotted?.setSize({ width, height: HEIGHT });
  }

  #options() {
    const axis = { stroke: style("--faint"), font: FONT };
    const grid = { stroke: style("--edge"), width: 1 };
    const ticks = { show: false };
    const minutes = { incrs: [60, 120, 300], values: (_, at) => at.map(clock) };
    const time = { ...axis, grid, ticks, size: 26, ...minutes };
    const value = { ...axis, grid, ticks, size: 48, values: (_, at) => at.map(String) };
    return {
      width: this.#box.clientWidth,
      height: HEIGHT,
      padding: [8, 8, 0, 0],
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, y: false },
      hooks: { setCursor: [({ cursor }) => this.#say(cursor.idx)] },
      scales: {
        x: { range: () => [this.#now - SPAN_S, this.#now] },
        y: { range: (_, __, most) => [0, 1.05 * Math.max(most ?? 0, this.#least)] },
      },
      axes: [time, value],
      series: [{}, ...this.#lines.map((_, line) => this.#series(line))],
      ...(this.#spec.stacked && { bands: this.#lines.slice(1).map((_, i) => band(i)) }),
    };
  }

  #series(line) {
    const stroke = color(line);
    const filled = this.#spec.stacked && line === 0;
    return { stroke, width: 1.5, points: { show: false }, ...(filled && { fill: stroke }) };
  }
}

/** Between a line and the one below it. */
const band = (i) => ({ series: [i + 2, i + 1], fill: color(i + 1) });
