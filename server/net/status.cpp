#include "net/status.h"

#include <algorithm>
#include <utility>

#include "common/log.h"
#include "net/agent_check.h"
#include "net/limits_in_use.h"
#include "net/state_page.h"

namespace amalgam::net {

frame::ServiceLoad Status::load() const {
  return service_ ? service_->load() : frame::ServiceLoad{};
}

std::string Status::not_alive() const {
  const frame::ServiceLoad now = load();
  const auto ms = [](std::chrono::milliseconds time) {
    return std::to_string(time.count()) + " ms";
  };
  if (now.without_progress >= config_.stuck_after) {
    return "the renderer has made no progress for " + ms(now.without_progress);
  }
  if (now.reloading >= config_.stuck_reload_after) {
    return "a new renderer has been under way for " + ms(now.reloading);
  }
  return "";
}

std::string Status::not_ready(Phase phase) const {
  switch (phase) {
    case Phase::Loading:
      return "loading";
    case Phase::Serving:
      if (limits_.full()) return "full";
      if (limits_.full_of_strangers()) return "too many connections without a hello";
      return "";
    case Phase::Leaving:
    case Phase::Draining:
    case Phase::Finished:
      return "draining";
  }
  return "";
}

std::string Status::agent_answer(Phase phase) const {
  if (phase != Phase::Serving) return "drain\n";
  return agent_line(std::min(limits_.free_part(), admission_.free_part(load())));
}

Gauges Status::gauges() const {
  return {.connections = limits_.total(),
          .unauthenticated = limits_.unauthenticated(),
          .session_memory = admission_.memory(),
          .load = load(),
          .dropped_log_lines = common::dropped_log_lines(),
          .records = recorder_.report().counts};
}

std::string Status::state(Phase phase, std::vector<SessionReport> sessions) const {
  ServerReport report;
  report.not_ready = not_ready(phase);
  report.not_alive = not_alive();
  report.ray_tracer = config_.ray_tracer;
  report.uptime = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - started_);
  report.cores = cores_;
  report.admin_pictures = config_.admin_pictures;
  report.connections = limits_.total();
  report.load = load();
  report.limits = limits_in_use(config_, limits_, admission_, report.load);
  report.records = recorder_.report();
  report.sessions = std::move(sessions);
  return state_json(report);
}

}  // namespace amalgam::net
