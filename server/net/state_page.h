// The /state page: the server's state as JSON, for people and scripts. Contains no secret.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "net/session_report.h"
#include "record/recorder.h"

namespace amalgam::net {

struct ServerReport {
  std::string not_ready;   // why; empty: ready
  std::string ray_tracer;  // its version
  std::chrono::seconds uptime{0};
  std::size_t connections = 0;
  record::RecorderReport records;
  std::vector<SessionReport> sessions;
};

std::string state_json(const ServerReport& report);

}  // namespace amalgam::net
