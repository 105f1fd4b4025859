#include "net/state_page.h"

#include "common/build_info.h"
#include "net/json_text.h"

namespace amalgam::net {
namespace {

std::string skips_text(const SessionReport& session) {
  JsonObject object;
  for (const Skip reason : kSkips) {
    object.add(to_string(reason), session.skipped_by[static_cast<std::size_t>(reason)]);
  }
  return object.end();
}

std::string stages_text(const core::StageTimes& stages) {
  JsonObject object;
  for (const core::StageTime& time : stages) object.add(time.stage, time.milliseconds);
  return object.end();
}

std::string passes_text(const std::vector<frame::PassRecord>& passes) {
  JsonArray array;
  for (const frame::PassRecord& pass : passes) {
    JsonObject object;
    object.add("name", pass.name);
    object.add("ran", pass.ran);
    object.add("reason", pass.reason);
    array.add_raw(object.end());
  }
  return array.end();
}

std::string quality_text(const frame::FrameQuality& quality) {
  JsonObject object;
  object.add("level", quality.level);
  object.add("lowest_level", quality.lowest_level);
  object.add("bound", frame::to_string(quality.bound));
  return object.end();
}

std::string session_text(const SessionReport& session) {
  JsonObject object;
  object.add("id", session.id);
  object.add("peer", session.peer);
  object.add("transport", session.transport);
  object.add("state", session.state);
  object.add("age_s", session.age.count());
  object.add("width", session.width);
  object.add("height", session.height);
  object.add("frames_received", session.received);
  object.add("frames_sent", session.sent);
  object.add("frames_skipped", session.skipped);
  object.add_raw("skipped_by", skips_text(session));
  object.add("frames_in_flight", session.in_flight);
  object.add("frames_unchanged", session.unchanged);
  object.add("frames_asked_per_second", session.frames_asked_per_second);
  object.add("frames_served_per_second", session.frames_served_per_second);
  object.add("bytes_received", session.bytes_received);
  object.add("bytes_sent", session.bytes_sent);
  if (const auto& time = session.server_ms) {
    object.add("server_ms_median", time->median);
    object.add("server_ms_p99", time->p99);
  }
  object.add_raw("stages_ms", stages_text(session.stages));
  object.add_raw("passes", passes_text(session.passes));
  if (session.quality) object.add_raw("quality", quality_text(*session.quality));
  object.add("own_environment", session.own_environment);
  object.add("record", session.record);
  object.add("record_bytes", session.record_bytes);
  object.add("picture", session.picture);
  return object.end();
}

std::string records_text(const record::RecorderReport& records) {
  JsonObject object;
  object.add("folder", records.folder);
  object.add("bytes_written", records.counts.bytes);
  object.add("begun", records.counts.begun);
  object.add("open", records.counts.begun - records.counts.ended);
  object.add("full", records.counts.full);
  object.add("too_slow", records.counts.too_slow);
  object.add("failed", records.counts.failed);
  return object.end();
}

std::string limits_text(const std::vector<ServerReport::Limit>& limits) {
  JsonObject object;
  for (const ServerReport::Limit& limit : limits) {
    JsonObject values;
    values.add("used", limit.used);
    values.add("most", limit.most);
    object.add_raw(limit.name, values.end());
  }
  return object.end();
}

}  // namespace

std::string state_json(const ServerReport& report) {
  JsonArray sessions("\n  ");
  for (const SessionReport& session : report.sessions) sessions.add_raw(session_text(session));
  JsonObject state;
  state.add("ready", report.not_ready.empty());
  state.add("not_ready", report.not_ready);
  state.add("alive", report.not_alive.empty());
  state.add("not_alive", report.not_alive);
  state.add("uptime_s", report.uptime.count());
  state.add("version", std::string(common::version()));
  state.add("instruction_set", std::string(common::instruction_set()));
  state.add("ray_tracer", report.ray_tracer);
  state.add("cores", report.cores);
  state.add("admin_pictures", report.admin_pictures);
  state.add("connections", report.connections);
  state.add_raw("records", records_text(report.records));
  state.add("queue_age_ms", report.load.queue_age.count());
  state.add("without_progress_ms", report.load.without_progress.count());
  state.add("reloading_ms", report.load.reloading.count());
  state.add_raw("limits", limits_text(report.limits));
  state.add_raw("sessions", sessions.end());
  return state.end();
}

}  // namespace amalgam::net
