#include "common/log_limiter.h"

#include <algorithm>
#include <utility>

namespace amalgam::common {

std::optional<std::uint64_t> LogLimiter::admit(LogKind kind, Time now) {
  const std::lock_guard lock(mutex_);
  Bucket& bucket = buckets_.at(static_cast<std::size_t>(kind));
  const double seconds = std::chrono::duration<double>(now - bucket.filled).count();
  bucket.tokens = std::min(kBurst, bucket.tokens + kPerSecond * std::max(seconds, 0.0));
  bucket.filled = now;
  if (bucket.tokens < 1.0) {
    ++bucket.left_out;
    return std::nullopt;
  }
  bucket.tokens -= 1.0;
  return std::exchange(bucket.left_out, 0);
}

}  // namespace amalgam::common
