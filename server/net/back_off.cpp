#include "net/back_off.h"

#include <algorithm>

namespace amalgam::net {

void BackOff::failed(const std::string& key, Time now) {
  if (failures_.size() >= kMaxAddresses && !failures_.contains(key)) {
    failures_.erase(std::min_element(
        failures_.begin(), failures_.end(),
        [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
  }
  Failures& failures = failures_[key];
  if (now - failures.last > kMemory) failures.count = 0;
  failures.last = now;
  const int paid = ++failures.count - kFree;
  if (paid <= 0) return;
  constexpr int kMostDoublings = 6;  // reaches kLongest
  failures.until = now + std::min(kFirst * (1 << std::min(paid - 1, kMostDoublings)), kLongest);
}

std::chrono::milliseconds BackOff::left(const std::string& key, Time now) const {
  const auto found = failures_.find(key);
  if (found == failures_.end() || found->second.until <= now) return {};
  return std::chrono::ceil<std::chrono::milliseconds>(found->second.until - now);
}

}  // namespace amalgam::net
