// A token bucket: so many events at once, and so many a second in the long run.
#pragma once

#include <algorithm>
#include <chrono>

namespace amalgam::common {

class RateLimit {
 public:
  using Time = std::chrono::steady_clock::time_point;
  RateLimit(double burst, double per_second) : burst_(burst), per_second_(per_second) {}

  bool admit(Time now) {
    const double seconds = std::chrono::duration<double>(now - filled_).count();
    left_ = std::min(burst_, left_ + per_second_ * std::max(seconds, 0.0));
    filled_ = now;
    if (left_ < 1.0) return false;
    left_ -= 1.0;
    return true;
  }

 private:
  double burst_, per_second_;
  double left_ = burst_;
  Time filled_{};
};

}  // namespace amalgam::common
