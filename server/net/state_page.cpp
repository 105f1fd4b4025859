#include "net/state_page.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "common/build_info.h"

namespace amalgam::net {
namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// An object as text. Not nlohmann's objects, whose destructors allocate: where memory is missing
// they end the process, and somebody who asks for this page must not be able to bring that about.
class ObjectText {
 public:
  void add(std::string_view key, const std::string& text) { add_raw(key, quoted(text)); }
  void add(std::string_view key, bool value) { add_raw(key, value ? "true" : "false"); }
  template <typename Number>
  void add(std::string_view key, Number value) {
    add_raw(key, std::to_string(value));
  }
  void add_raw(std::string_view key, const std::string& json) {
    text_.append(text_.empty() ? "{" : ", ").append("\"").append(key).append("\": ").append(json);
  }
  std::string end() const { return text_ + "}"; }

 private:
  std::string text_;
};

std::string session_text(const SessionReport& session) {
  ObjectText object;
  object.add("id", session.id);
  object.add("peer", session.peer);
  object.add("transport", session.transport);
  object.add("state", session.state);
  object.add("width", session.width);
  object.add("height", session.height);
  object.add("frames_received", session.received);
  object.add("frames_sent", session.sent);
  object.add("frames_skipped", session.skipped);
  object.add("frames_in_flight", session.in_flight);
  object.add("own_environment", session.own_environment);
  object.add("record", session.record);
  object.add("record_bytes", session.record_bytes);
  return object.end();
}

std::string records_text(const record::RecorderReport& records) {
  ObjectText object;
  object.add("folder", records.folder);
  object.add("bytes_written", records.counts.bytes);
  object.add("begun", records.counts.begun);
  object.add("open", records.counts.begun - records.counts.ended);
  object.add("full", records.counts.full);
  object.add("too_slow", records.counts.too_slow);
  object.add("failed", records.counts.failed);
  return object.end();
}

}  // namespace

std::string state_json(const ServerReport& report) {
  std::string sessions;
  for (const SessionReport& session : report.sessions) {
    sessions.append(sessions.empty() ? "\n  " : ",\n  ").append(session_text(session));
  }
  ObjectText state;
  state.add("ready", report.not_ready.empty());
  state.add("not_ready", report.not_ready);
  state.add("uptime_s", report.uptime.count());
  state.add("version", std::string(common::version()));
  state.add("instruction_set", std::string(common::instruction_set()));
  state.add("ray_tracer", report.ray_tracer);
  state.add("connections", report.connections);
  state.add_raw("records", records_text(report.records));
  state.add_raw("sessions", "[" + sessions + "]");
  return state.end();
}

}  // namespace amalgam::net
