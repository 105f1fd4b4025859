#include "frame/relative_costs.h"

#include <algorithm>
#include <cmath>

namespace amalgam::frame {

void RelativeCosts::learn(std::size_t from, std::size_t to, double measured) {
  if (from == to || !(measured > 0.0) || !std::isfinite(measured)) return;
  // Clamped, because more than the quality may have changed.
  const double correction = std::clamp(measured / ratio(to, from), 0.25, 4.0);
  const double distance = static_cast<double>(to) - static_cast<double>(from);
  for (std::size_t level = 0; level < costs_.size(); ++level) {
    const double way = (static_cast<double>(level) - static_cast<double>(from)) / distance;
    costs_[level] *= std::pow(correction, std::clamp(way, 0.0, 1.0));
  }
  // Less quality never costs more. The level just measured is kept, the others are adjusted.
  for (std::size_t level = to; level-- > 0;) {
    costs_[level] = std::max(costs_[level], costs_[level + 1]);
  }
  for (std::size_t level = to + 1; level < costs_.size(); ++level) {
    costs_[level] = std::min(costs_[level], costs_[level - 1]);
  }
}

}  // namespace amalgam::frame
