// The laws that errors are expected to follow (numerics, part C), and whether they do.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/summary.h"

namespace amalgam::report {

// Display-linear. Points with less error say nothing of their knob: the two renderers' arithmetic
// may differ by so much, by 1e-8 where no ray grazes an edge.
constexpr double kNoEffect = 1e-6;

// A measured slope may lie so far outside what is expected, in relation to it.
constexpr double kSlopeTolerance = 0.1;

struct Law {
  std::string scene, sweep;
  std::string quantity;  // of the slope: "ln error a bounce"
  std::string expected;  // "-0.75 to -0.5"
  double low = 0.0, high = 0.0;
  double slope = 0.0;
  bool pass = false;
};

// Of all sweeps and scenes that have one: a power of the number of samples and of lights; and for
// scenes that are mentioned in reflectances, which says what a mirror of theirs reflects, a power
// of the cut-off and an exponential of the depth. The error is the one to the knob's limit. A sweep
// in which fewer than three points have such an error has no law.
std::vector<Law> find_laws(const std::vector<PointSummary>& points,
                           const std::map<std::string, double>& reflectances);

// Writes the slopes to the points of their sweeps.
void set_slopes(std::vector<PointSummary>& points, const std::vector<Law>& laws);

}  // namespace amalgam::report
