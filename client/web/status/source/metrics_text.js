// Reads Prometheus' text format, as far as this server writes it.

const LINE = /^(\w+)(?:\{(.*)\})? (\S+)$/;
const LABEL = /(\w+)="((?:[^"\\]|\\.)*)"/g;

const unescape = (text) => text.replace(/\\(.)/g, (_, c) => (c === "n" ? "\n" : c));

export class Metrics {
  #samples = new Map(); // name -> [{labels, value}]

  /** @param {string} text of /metrics */
  constructor(text) {
    for (const line of text.split("\n")) {
      const [, name, labels = "", value] = (!line.startsWith("#") && LINE.exec(line)) || [];
      if (!name) continue;
      const sample = { labels: {}, value: toNumber(value) };
      for (const [, key, label] of labels.matchAll(LABEL)) sample.labels[key] = unescape(label);
      if (!this.#samples.has(name)) this.#samples.set(name, []);
      this.#samples.get(name).push(sample);
    }
  }

  /** @returns {{labels: Record<string, string>, value: number}[]} */
  all(name) {
    return this.#samples.get(name) ?? [];
  }

  /** @returns {number} over all labels; NaN if there is none of this name */
  sum(name) {
    const samples = this.all(name);
    return samples.length ? samples.reduce((sum, { value }) => sum + value, 0) : NaN;
  }

  /** @returns {Map<string, number>} by one label */
  by(name, label) {
    return new Map(this.all(name).map(({ labels, value }) => [labels[label], value]));
  }

  /** @returns {{le: number[], counts: number[]}} cumulated, as Prometheus has them */
  histogram(name) {
    const buckets = this.all(`${name}_bucket`)
      .map(({ labels, value }) => [toNumber(labels.le), value])
      .sort(([a], [b]) => a - b);
    return { le: buckets.map(([le]) => le), counts: buckets.map(([, count]) => count) };
  }
}

const toNumber = (text) => Number(text.replace(/^\+?Inf$/, "Infinity"));
