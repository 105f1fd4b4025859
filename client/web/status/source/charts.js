// All charts, and the history that they show.
import { Chart } from "./chart.js";
import { CHARTS } from "./chart_data.js";
import { History } from "./history.js";

export class Charts {
  #history = new History();
  #charts = CHARTS.map((spec) => new Chart(spec));
  #state = { cores: 1 };

  /** @param {HTMLElement} parent */
  constructor(parent) {
    parent.append(...this.#charts.map(({ element }) => element));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      for (const chart of this.#charts) chart.repaint();
    });
  }

  /** @param {number} time ms */
  answered(state, metrics, time) {
    this.#state = state;
    this.#history.add(time / 1000, state, metrics);
    this.#update(time);
  }

  silent(time) {
    this.#history.addGap(time / 1000);
    this.#update(time);
  }

  #update(time) {
    for (const chart of this.#charts) chart.update(this.#history, this.#state, time / 1000);
  }
}
