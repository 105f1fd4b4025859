// Numbers and states in words. Knows nothing of the page, so that it can be tested.

const UNITS = ["B", "kB", "MB", "GB", "TB"];

/** Whole, or with three digits: more nobody looks at. */
export function number(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (Number.isInteger(value)) return String(value);
  if (Math.abs(value) >= 100) return value.toFixed(0);
  return value.toFixed(Math.abs(value) >= 10 ? 1 : 2);
}

export function bytes(value) {
  let unit = 0;
  let rest = value;
  while (rest >= 999.5 && unit + 1 < UNITS.length) {
    rest /= 1000;
    ++unit;
  }
  return `${unit === 0 ? rest.toFixed(0) : number(rest)} ${UNITS[unit]}`;
}

export function duration(seconds) {
  const whole = Math.floor(seconds);
  if (whole < 60) return `${whole} s`;
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) return `${minutes} min ${whole % 60} s`;
  const hours = Math.floor(minutes / 60);
  if (hours < 48) return `${hours} h ${minutes % 60} min`;
  return `${Math.floor(hours / 24)} d ${hours % 24} h`;
}

/** Names as they are in metrics and passes. */
export const plain = (name) => name.replaceAll("_", " ");

export const plural = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

/**
 * @param {object} state of /state
 * @returns {{kind: string, text: string}} kind: as the chip knows it
 */
export function readiness(state) {
  if (!state.alive) return { kind: "refused", text: `stuck: ${state.not_alive}` };
  if (!state.ready) return { kind: "busy", text: `not ready: ${state.not_ready}` };
  return { kind: "ready", text: "ready" };
}

export function about({ version, uptime_s: uptime, ray_tracer: tracer, cores }) {
  return `${version} · up ${duration(uptime)} · ${plural(cores, "core")} · ${tracer}`;
}

const SKIPS = {
  replaced_before_render: "a newer frame came before its turn",
  replaced_before_write: "a newer composite came before it was read",
  refused: "refused with an error",
  draining: "came while draining",
  closed: "the session ended first",
};

/** @returns {[string, number][]} reasons that occurred, in words */
export function skips(counts) {
  return Object.entries(counts)
    .filter(([, count]) => count > 0)
    .map(([reason, count]) => [SKIPS[reason] ?? plain(reason), count]);
}
