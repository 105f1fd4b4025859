// A client that sends frame after frame on a thread of its own, so that its session stays alive
// while others are looked at.
#pragma once

#include <atomic>
#include <exception>
#include <thread>

#include "bench/session.h"

namespace amalgam::bench {

class StreamingSession {
 public:
  // The case must outlive it. Throws std::runtime_error.
  StreamingSession(const common::HostPort& server, const BenchCase& bench_case);

  // Until so many composites have come. Throws what ended the session, if something did.
  void wait_for(int composites) const;

 private:
  void stream(const std::stop_token& stop);

  Session session_;
  std::atomic<int> composites_ = 0;
  std::exception_ptr failure_;  // read once failed_ is set
  std::atomic<bool> failed_ = false;
  std::jthread thread_{[this](const std::stop_token& stop) { stream(stop); }};
};

}  // namespace amalgam::bench
