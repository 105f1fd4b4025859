// What many short measurements say: percentiles, and how sure a mean is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace amalgam::report {

// Throws std::invalid_argument if empty, as all functions here.
double mean(std::span<const double> values);

// share in [0, 1]: 0.05 is the fifth percentile. Linear between neighbours: of n sorted values the
// one with index share (n - 1).
double percentile(std::vector<double> values, double share);

struct Interval {
  double low = 0.0, high = 0.0;
};

// The 95 % bootstrap interval of the mean (Efron 1979): percentiles 2.5 and 97.5 of the means of
// 2000 samples drawn with replacement. The same seed gives the same interval on every machine.
Interval bootstrap_mean(std::span<const double> values, std::uint64_t seed = 1);

}  // namespace amalgam::report
