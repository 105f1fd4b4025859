// Percentiles, as clients and the load program print them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace amalgam::common {

// The smallest of the values that the given share of them (0 to 1) does not exceed; 0 of nothing.
template <typename Number>
double nearest_rank(const std::vector<Number>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return static_cast<double>(sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1]);
}

}  // namespace amalgam::common
