// How often something happened within the last seconds. Takes no memory while it counts.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>

namespace amalgam::net {

class EventRate {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kWindow{5};

  void happened(Time now) {
    if (count_ == 0) first_ = now;
    times_[count_++ % times_.size()] = now;
  }

  // A second, over the last kWindow, or since the first if that is less. Where more happened than
  // are remembered, over the time that those took.
  double rate(Time now) const {
    const std::size_t kept = std::min(count_, times_.size());
    const auto recent = std::count_if(times_.begin(), times_.begin() + static_cast<long>(kept),
                                      [&](Time time) { return now - time < kWindow; });
    if (recent == 0) return 0.0;
    Time begin = std::max(first_, now - kWindow);
    const bool all_recent = static_cast<std::size_t>(recent) == times_.size();
    if (all_recent) begin = times_[count_ % times_.size()];  // the oldest that is remembered
    // A first event says little: it is not taken for one of many.
    const double least = all_recent ? 1e-3 : 1.0;
    return static_cast<double>(recent) /
           std::max(std::chrono::duration<double>(now - begin).count(), least);
  }

 private:
  std::array<Time, 256> times_{};
  std::size_t count_ = 0;
  Time first_{};
};

}  // namespace amalgam::net
