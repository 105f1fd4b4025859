#include "report/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amalgam::report {
namespace {

constexpr double kRoom = 0.08;      // of the values' span, at each end
constexpr double kLeastSpan = 0.3;  // powers of ten: values that are all alike fill no axis

// Which numbers of each power of ten are written along an axis of so many of them.
std::vector<double> digits(double span) {
  if (span > 3.0) return {1.0};
  if (span > 1.0) return {1.0, 2.0, 5.0};
  return {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0};
}

}  // namespace

double LogAxis::place(double value) const {
  return std::log(value / low) / std::log(high / low);
}

LogAxis log_axis(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) continue;
    low = std::min(low, std::log10(value));
    high = std::max(high, std::log10(value));
  }
  const double missing = std::max(0.0, kLeastSpan - (high - low));
  const double room = kRoom * std::max(kLeastSpan, high - low) + 0.5 * missing;
  low -= room;
  high += room;
  LogAxis axis{.low = std::pow(10.0, low), .high = std::pow(10.0, high), .ticks = {}};
  for (int power = static_cast<int>(std::floor(low)); power <= static_cast<int>(std::ceil(high));
       ++power) {
    for (const double digit : digits(high - low)) {
      const double tick = digit * std::pow(10.0, power);
      if (tick >= axis.low && tick <= axis.high) axis.ticks.push_back(tick);
    }
  }
  return axis;
}

}  // namespace amalgam::report
