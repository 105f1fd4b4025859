#include "net/state_page.h"

#include <nlohmann/json.hpp>

#include "common/build_info.h"

namespace amalgam::net {

std::string state_json(const ServerReport& report) {
  nlohmann::ordered_json sessions = nlohmann::ordered_json::array();
  for (const SessionReport& session : report.sessions) {
    sessions.push_back({{"id", session.id},
                        {"peer", session.peer},
                        {"state", session.state},
                        {"width", session.width},
                        {"height", session.height},
                        {"frames_received", session.received},
                        {"frames_sent", session.sent},
                        {"frames_skipped", session.skipped},
                        {"frames_in_flight", session.in_flight}});
  }
  const nlohmann::ordered_json state = {{"ready", report.not_ready.empty()},
                                        {"not_ready", report.not_ready},
                                        {"uptime_s", report.uptime.count()},
                                        {"version", common::version()},
                                        {"instruction_set", common::instruction_set()},
                                        {"ray_tracer", report.ray_tracer},
                                        {"connections", report.connections},
                                        {"sessions", sessions}};
  return state.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace amalgam::net
