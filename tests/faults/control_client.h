// A healthy client that runs beside a fault, and tells what it felt of it.
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "support/net/test_client.h"

namespace amalgam::test {

class ControlClient {
 public:
  explicit ControlClient(const common::HostPort& server, const std::string& token = "");
  ~ControlClient();

  struct Felt {
    std::size_t frames = 0;
    double median_ms = 0.0, p99_ms = 0.0, worst_ms = 0.0;
    bool lost = false;  // the server closed, or said something unexpected
  };
  // Ends it. A machine that is busy with other work is felt too, so limits should be wide.
  Felt end();

 private:
  void run();

  TestClient client_;
  std::atomic<bool> stop_ = false;
  std::vector<double> milliseconds_;
  bool lost_ = false;
  std::thread thread_;
};

}  // namespace amalgam::test
