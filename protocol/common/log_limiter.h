// Limits how many log lines of one kind there are, because strangers can cause as many as they like
// of some. May be used from any thread.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>

#include "common/log.h"
#include "common/rate_limit.h"

namespace amalgam::common {

class LogLimiter {
 public:
  using Time = RateLimit::Time;
  static constexpr double kBurst = 20.0;      // lines at once
  static constexpr double kPerSecond = 10.0;  // lines in the long run

  // Nothing if the line is to be left out; otherwise how many were left out since the last one.
  std::optional<std::uint64_t> admit(LogKind kind, Time now);

 private:
  struct Bucket {
    RateLimit limit{kBurst, kPerSecond};
    std::uint64_t left_out = 0;
  };
  std::mutex mutex_;
  std::array<Bucket, kLogKinds> buckets_;
};

}  // namespace amalgam::common
