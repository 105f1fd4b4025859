// The status page begins here: its parts are found and fed.
import { Charts } from "./charts.js";
import { byId, say } from "./dom.js";
import { Limits } from "./limits.js";
import { Poller } from "./poller.js";
import { Sessions } from "./sessions.js";
import { about, duration, plural, readiness } from "./words.js";

const charts = new Charts(byId("charts"));
const limits = new Limits(byId("limits"));
const sessions = new Sessions({
  table: byId("sessions"),
  title: byId("sessions-title"),
  none: byId("no-sessions"),
  hint: byId("pictures-hint"),
});

function showChip({ kind, text }) {
  say(byId("chip"), text);
  byId("chip").dataset.kind = kind;
}

function answered(state, metrics, time) {
  byId("banner").hidden = true;
  document.body.classList.remove("silent");
  const ready = readiness(state);
  showChip(ready);
  say(byId("about"), about(state));
  document.title = `Amalgam: ${ready.text}, ${plural(state.sessions.length, "session")}`;
  limits.update(state.limits);
  sessions.update(state);
  charts.answered(state, metrics, time);
}

function silent(since, time) {
  const clock = new Date(since).toLocaleTimeString([], { hourCycle: "h23" });
  say(
    byId("banner-text"),
    `The server has not answered since ${clock}. It is asked again each second; ` +
      "what is below is from before.",
  );
  // Apart, because a screen reader would say it anew each second.
  say(byId("banner-age"), duration((time - since) / 1000));
  byId("banner").hidden = false;
  document.body.classList.add("silent");
  showChip({ kind: "refused", text: "no answer" });
  document.title = "Amalgam: no answer";
  charts.silent(time);
}

new Poller({ answered, silent }).run();
