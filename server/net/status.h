// What the server tells of itself: to probes (/livez, /readyz), to load balancers, to /metrics and
// /state. On the network thread.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/cpu_count.h"
#include "frame/frame.h"
#include "net/admission.h"
#include "net/connection_limits.h"
#include "net/metrics.h"
#include "net/server_config.h"
#include "net/session_report.h"
#include "record/recorder.h"

namespace amalgam::net {

// Leaving: still serves everybody, but tells load balancers to look elsewhere.
enum class Phase { Loading, Serving, Leaving, Draining, Finished };

class Status {
 public:
  // All outlive this.
  Status(const ServerConfig& config, const ConnectionLimits& limits, const Admission& admission,
         const record::Recorder& recorder)
      : config_(config), limits_(limits), admission_(admission), recorder_(recorder) {}

  // Before there is one, the renderer's load is none.
  void set_service(const frame::FrameService& service) { service_ = &service; }

  // Why the server should be restarted, or should get no new client; empty: all is well.
  std::string not_alive() const;
  std::string not_ready(Phase phase) const;
  // A line of the agent's protocol (net/agent_check.h).
  std::string agent_answer(Phase phase) const;
  Gauges gauges() const;
  // The /state page.
  std::string state(Phase phase, std::vector<SessionReport> sessions) const;

 private:
  using Clock = std::chrono::steady_clock;

  frame::ServiceLoad load() const;

  const ServerConfig& config_;
  const ConnectionLimits& limits_;
  const Admission& admission_;
  const record::Recorder& recorder_;
  const frame::FrameService* service_ = nullptr;
  Clock::time_point started_ = Clock::now();
  int cores_ = core::usable_cpus();
};

}  // namespace amalgam::net
