// Repeated measurements of two things by turns, and the ratio of the two.
//
// On a machine that others use too, single times wander by half. Both sides of a ratio are taken in
// each round, one after the other, so that what slows the machine slows both; the ratio is the
// median of the rounds' ratios.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace amalgam::bench {

// Of an even number, the mean of the two in the middle. Throws std::invalid_argument if empty.
double median(std::vector<double> values);

struct Ratio {
  double value = 0.0;             // median of the rounds
  double low = 0.0, high = 0.0;   // least and greatest of the rounds
  double above = 0.0, below = 0;  // medians of the two sides
  int rounds = 0;
};

// above[i] / below[i] is one round. Throws std::invalid_argument unless there are as many of both,
// and at least one.
Ratio ratio_of_rounds(const std::vector<double>& above, const std::vector<double>& below);

struct Rounds {
  int least = 2, most = 9;
  double seconds = 10.0;  // no round begins after this once there are enough
};

// Runs above(), below(), above(), ... each of which returns its measurement.
Ratio measure_by_turns(const Rounds& rounds, const std::function<double()>& above,
                       const std::function<double()>& below);

// "12.3 ms / 45.6 ms, 5 rounds"; unit as it is to be printed.
std::string describe(const Ratio& ratio, const std::string& unit = "ms");

}  // namespace amalgam::bench
