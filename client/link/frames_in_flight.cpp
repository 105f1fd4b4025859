#include "client/link/frames_in_flight.h"

#include <algorithm>

#include "common/nearest_rank.h"

namespace amalgam::client {

void FramesInFlight::captured(std::uint64_t id, Clock::time_point at) {
  open_.emplace(id, at);
  ++counts_.captured;
}

void FramesInFlight::skipped(std::uint64_t id) {
  counts_.skipped_by_client += open_.erase(id);
}

void FramesInFlight::rejected(std::uint64_t id) {
  counts_.rejected += open_.erase(id);
}

void FramesInFlight::composited(std::uint64_t id, bool unchanged, Clock::time_point at) {
  const auto frame = open_.find(id);
  if (frame == open_.end()) return;  // not ours, or answered twice
  const std::chrono::duration<float, std::milli> latency = at - frame->second;
  latencies_.push_back(latency.count());
  ++counts_.composited;
  counts_.unchanged += unchanged ? 1 : 0;
  counts_.skipped_by_server += static_cast<std::uint64_t>(std::distance(open_.begin(), frame));
  open_.erase(open_.begin(), std::next(frame));
}

void FramesInFlight::lost_up_to(std::uint64_t id) {
  const auto end = open_.upper_bound(id);
  counts_.lost += static_cast<std::uint64_t>(std::distance(open_.begin(), end));
  open_.erase(open_.begin(), end);
}

LatencySummary FramesInFlight::latency() const {
  std::vector<float> sorted = latencies_;
  std::ranges::sort(sorted);
  return {.median = common::nearest_rank(sorted, 0.5),
          .p95 = common::nearest_rank(sorted, 0.95),
          .p99 = common::nearest_rank(sorted, 0.99)};
}

}  // namespace amalgam::client
