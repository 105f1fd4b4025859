// Keeps a client's capture times plausible. A time is clamped if it lies before its predecessor's,
// or ahead of it by more than the time between arrivals plus kMaxCaptureLead.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "protocol/limits.h"

namespace amalgam::net {

class CaptureClock {
 public:
  using Time = std::chrono::steady_clock::time_point;

  struct Judged {
    std::uint64_t time_us = 0;
    bool clamped = false;
  };

  Judged judge(std::uint64_t time_us, Time arrival) {
    Judged judged{time_us, false};
    if (previous_) {
      const auto lead = std::chrono::duration_cast<std::chrono::microseconds>(
          arrival - previous_->arrival + protocol::kMaxCaptureLead);
      const auto room = static_cast<std::uint64_t>(lead.count());
      const std::uint64_t earliest = previous_->time_us;
      const std::uint64_t latest = earliest > UINT64_MAX - room ? UINT64_MAX : earliest + room;
      judged.time_us = std::clamp(time_us, earliest, latest);
      judged.clamped = judged.time_us != time_us;
    }
    // Raw, not clamped: a clock that was set once is clamped for one frame only.
    previous_ = {time_us, arrival};
    return judged;
  }

 private:
  struct Sample {
    std::uint64_t time_us;
    Time arrival;
  };
  std::optional<Sample> previous_;
};

}  // namespace amalgam::net
