// What each chart shows, as lines of the History. Knows nothing of the page, so that it can be
// tested.
import { plain } from "./words.js";

const MOST_STAGES = 6; // more colors nobody tells apart

/**
 * A chart: lines, from the bottom up if they are stacked. least: what its axis reaches at least.
 * @typedef {{label: string, values: (number | null)[]}} Line
 */

const lines = (...named) => (history) =>
  named.map(([name, label]) => ({ label, values: history.column(name) }));

export const CHARTS = [
  {
    id: "frames",
    title: "Frames",
    unit: "a second",
    lines: lines(["received", "received"], ["sent", "sent back"], ["skipped", "skipped"]),
    least: () => 1,
  },
  {
    id: "stages",
    title: "Stages of a frame",
    unit: "ms, stacked",
    stacked: true,
    lines: stageLines,
    least: () => 1,
  },
  {
    id: "delay",
    title: "Delay in the server",
    unit: "ms",
    lines: lines(["median", "median"], ["p99", "99th percentile"], ["waiting", "oldest waiting"]),
    least: () => 1,
  },
  {
    id: "connections",
    title: "Connections",
    unit: "",
    lines: lines(["connections", "connections"], ["sessions", "of these, sessions"]),
    least: () => 4,
  },
  {
    id: "processor",
    title: "Processor",
    unit: "cores",
    lines: lines(["cpu", "used"]),
    least: ({ cores }) => cores,
  },
  {
    id: "memory",
    title: "Memory",
    unit: "MB",
    lines: lines(["memory", "resident"]),
    least: () => 1,
  },
];

/** @returns {Line[]} the longest stages, and the rest as one */
function stageLines(history) {
  const stages = history.stages();
  const shown = stages.slice(0, MOST_STAGES);
  const result = shown.map((stage) => ({
    label: plain(stage),
    values: history.column(`stage:${stage}`),
  }));
  const rest = stages.slice(MOST_STAGES).map((stage) => history.column(`stage:${stage}`));
  if (rest.length > 0) {
    const values = history.times.map((_, i) => sum(rest.map((column) => column[i])));
    result.push({ label: "others", values });
  }
  return result;
}

/** Each line becomes the sum of those below it and its own; a gap where none has a value. */
export function stacked(all) {
  const columns = all.map(({ values }) => values);
  return columns.map((column, line) =>
    column.map((_, i) => {
      const here = columns.map((values) => values[i]);
      return here.every((value) => value === null) ? null : sum(here.slice(0, line + 1)) ?? 0;
    }),
  );
}

function sum(values) {
  const there = values.filter((value) => value !== null);
  return there.length > 0 ? there.reduce((total, value) => total + value, 0) : null;
}
