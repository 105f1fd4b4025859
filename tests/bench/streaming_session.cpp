#include "bench/streaming_session.h"

#include <chrono>

namespace amalgam::bench {

StreamingSession::StreamingSession(const common::HostPort& server, const BenchCase& bench_case)
    : session_(server, bench_case) {}

void StreamingSession::stream(const std::stop_token& stop) {
  try {
    while (!stop.stop_requested()) {
      session_.round_trip_milliseconds();
      ++composites_;
    }
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
  }
}

void StreamingSession::wait_for(int composites) const {
  while (composites_ < composites) {
    if (failed_) std::rethrow_exception(failure_);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace amalgam::bench
