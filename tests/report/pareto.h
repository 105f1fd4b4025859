// Which settings are worth their time.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace amalgam::report {

struct Cost {
  double time = 0.0;   // milliseconds
  double error = 0.0;  // what has none (NaN) takes no part
};

// By point: no other one is at least as good in both and better in one.
std::vector<bool> pareto_flags(std::span<const Cost> points);

// Of all points that take no longer, the one with the least error; of equal ones the first.
// Nothing if that is the point itself.
std::optional<std::size_t> equal_time_partner(std::span<const Cost> points, std::size_t of);

// Of all points that are no further off, the fastest; of equal ones the first. Nothing if that is
// the point itself.
std::optional<std::size_t> equal_error_partner(std::span<const Cost> points, std::size_t of);

}  // namespace amalgam::report
