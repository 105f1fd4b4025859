// The /state page: the server's state as JSON, for people, scripts and the status page. Contains no
// secret. The comments give the fields' names, where those are not the same.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "net/session_report.h"
#include "record/recorder.h"

namespace amalgam::net {

struct ServerReport {
  std::string not_ready;           // why; empty: ready, which also is a field of its own
  std::string not_alive;           // why; empty: alive, likewise
  std::string ray_tracer;          // its version
  std::chrono::seconds uptime{0};  // uptime_s
  int cores = 0;                   // that the server may use
  bool admin_pictures = false;     // whether the last composites are kept for /pictures/ID.jpg
  std::size_t connections = 0;
  record::RecorderReport records;
  frame::ServiceLoad load;  // queue_age_ms, without_progress_ms, reloading_ms
  // limits: an object by name, each with used and most; 0: no limit.
  struct Limit {
    const char* name = "";
    double used = 0.0, most = 0.0;
  };
  std::vector<Limit> limits;
  std::vector<SessionReport> sessions;
};

std::string state_json(const ServerReport& report);

}  // namespace amalgam::net
