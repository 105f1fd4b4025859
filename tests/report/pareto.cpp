#include "report/pareto.h"

#include <algorithm>
#include <utility>

namespace amalgam::report {
namespace {

bool beats(const Cost& a, const Cost& b) {
  return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
}

// The least `sought` among points whose `limited` is no larger than that of the given one.
std::optional<std::size_t> partner(std::span<const Cost> points, std::size_t of,
                                   double Cost::*limited, double Cost::*sought) {
  std::size_t best = of;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].*limited <= points[of].*limited && points[i].*sought < points[best].*sought) {
      best = i;
    }
  }
  if (best == of) return std::nullopt;
  return best;
}

}  // namespace

std::vector<bool> pareto_flags(std::span<const Cost> points) {
  std::vector<bool> flags;
  for (const Cost& point : points) {
    const bool comparable = point.time == point.time && point.error == point.error;
    flags.push_back(comparable &&
                    std::none_of(points.begin(), points.end(),
                                 [&](const Cost& other) { return beats(other, point); }));
  }
  return flags;
}

std::optional<std::size_t> equal_time_partner(std::span<const Cost> points, std::size_t of) {
  return partner(points, of, &Cost::time, &Cost::error);
}

std::optional<std::size_t> equal_error_partner(std::span<const Cost> points, std::size_t of) {
  return partner(points, of, &Cost::error, &Cost::time);
}

}  // namespace amalgam::report
