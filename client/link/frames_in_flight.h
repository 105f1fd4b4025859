// Accounts for every captured frame: each ends as composited, skipped, rejected or lost.
//
// Frames and composites are newest-wins on both sides and keep their order. So after the answer to
// a frame, earlier open ones will never be answered.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <vector>

namespace amalgam::client {

struct LatencySummary {  // milliseconds from capture to composite; 0 without any
  double median = 0.0, p95 = 0.0, p99 = 0.0;
};

struct FrameCounts {
  std::uint64_t captured = 0;
  std::uint64_t composited = 0;
  std::uint64_t unchanged = 0;          // of the composited: came back byte for byte
  std::uint64_t skipped_by_client = 0;  // replaced by a newer frame before it was sent
  std::uint64_t skipped_by_server = 0;  // never answered, although a later one was
  std::uint64_t rejected = 0;           // answered with an Error
  std::uint64_t lost = 0;               // sent or waiting when the connection broke or ended
};

class FramesInFlight {
 public:
  using Clock = std::chrono::steady_clock;

  void captured(std::uint64_t id, Clock::time_point at);
  void skipped(std::uint64_t id);  // by this client
  void composited(std::uint64_t id, bool unchanged, Clock::time_point at);
  void rejected(std::uint64_t id);
  // Open frames up to this id are lost: the connection broke after they were handed to it.
  void lost_up_to(std::uint64_t id);

  bool has_open() const { return !open_.empty(); }
  bool is_open(std::uint64_t id) const { return open_.contains(id); }
  const FrameCounts& counts() const { return counts_; }
  LatencySummary latency() const;

 private:
  std::map<std::uint64_t, Clock::time_point> open_;
  std::vector<float> latencies_;  // milliseconds
  FrameCounts counts_;
};

}  // namespace amalgam::client
