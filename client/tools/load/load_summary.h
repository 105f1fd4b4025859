// The fate of all frames of all clients, as one JSON object.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace amalgam::load {

struct LoadSummary {
  int clients = 0;
  int welcomed = 0;
  int lost = 0;              // connections that failed or ended before their client was done
  std::uint64_t sent = 0;    // frames
  std::uint64_t unsent = 0;  // due while the previous one was still being written
  std::uint64_t composited = 0;
  std::uint64_t unchanged = 0;                  // of these: came back byte for byte
  std::uint64_t skipped = 0;                    // as the server counted them
  std::map<std::string, std::uint64_t> errors;  // by code
  std::vector<double> latencies_ms;             // from when it was due to its composite
  struct Due {
    double second;   // since the start of the load
    double latency;  // ms, until a composite of this frame or of a later one
  };
  std::vector<Due> due;          // all frames that were due and have such a composite
  std::uint64_t unanswered = 0;  // frames that were due and have none
  std::uint64_t bytes_sent = 0, bytes_received = 0;
  double seconds = 0.0;
};

std::string to_json(LoadSummary summary);

}  // namespace amalgam::load
