// A client's session in the bench: sends frames of a case to a server and waits for composites.
#pragma once

#include <cstdint>

#include "bench/bench_case.h"
#include "support/net/test_client.h"

namespace amalgam::bench {

class Session {
 public:
  // Says hello with the case's camera. The case must outlive the session. Throws
  // std::runtime_error.
  Session(const common::HostPort& server, const BenchCase& bench_case);

  // Sends a frame and waits for its composite; the time that took.
  double round_trip_milliseconds();
  // Composites a second: a frame is always waiting while another is rendered.
  double frames_per_second(double seconds);

 private:
  void send_frame();
  void receive_composite();

  const BenchCase& case_;
  test::TestClient client_;
  protocol::Envelope frame_;
  std::uint64_t last_frame_ = 0, last_answered_ = 0;
};

}  // namespace amalgam::bench
