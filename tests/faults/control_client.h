// A healthy client that runs beside a fault, and tells what it felt of it. Speaks as amalgam-client
// does, by its library. Server, attacker and this client share a machine of two processors, and a
// percentile wants hundreds of frames. So an attacker pauses between its attacks: otherwise the
// worst frames show how long this client's threads wait for a processor.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "client/link/connection.h"
#include "common/host_port.h"

namespace amalgam::test {

class ControlClient {
 public:
  // Throws std::runtime_error if there is no session.
  explicit ControlClient(const common::HostPort& server, const std::string& token = "");
  ~ControlClient();

  struct Felt {
    std::size_t frames = 0;
    double median_ms = 0.0, p99_ms = 0.0, worst_ms = 0.0;
    bool lost = false;  // the server closed, or said something unexpected
  };
  // Ends it. A machine that is busy with other work is felt too: see expect_unharmed().
  Felt end();
  // What one feels for a moment without any fault, to compare with.
  static Felt feel_alone(const common::HostPort& server, const std::string& token = "");

 private:
  void run();
  // The next event, if it is of this kind and comes within ten seconds.
  template <typename Event>
  std::optional<Event> next();

  client::Connection connection_;
  std::atomic<bool> stop_ = false;
  std::vector<double> milliseconds_;
  bool lost_ = false;
  std::thread thread_;
};

// Prints the healthy client's worst percent, alone and beside the row's fault. It must not have
// been lost. That it waited at most 10 % or allowed_ms longer is asserted if AMALGAM_QUIET_MACHINE
// is set, which says that nothing else needs the machine's processors.
void expect_unharmed(const std::string& row, const ControlClient::Felt& alone,
                     const ControlClient::Felt& beside, double allowed_ms = 2.0);

}  // namespace amalgam::test
