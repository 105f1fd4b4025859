#include "common/log_limiter.h"

#include <utility>

namespace amalgam::common {

std::optional<std::uint64_t> LogLimiter::admit(LogKind kind, Time now) {
  const std::lock_guard lock(mutex_);
  Bucket& bucket = buckets_.at(static_cast<std::size_t>(kind));
  if (!bucket.limit.admit(now)) {
    ++bucket.left_out;
    return std::nullopt;
  }
  return std::exchange(bucket.left_out, 0);
}

}  // namespace amalgam::common
