// Whether the bound that frames state on what cutting rays off has changed holds in the sweeps, and
// how wide it is.
#pragma once

#include <string>
#include <vector>

#include "report/run_row.h"

namespace amalgam::report {

struct BoundCheck {
  std::string scene;
  int settings = 0;         // of the sweeps of depth and cut-off, with an error above kNoEffect
  int held = 0;             // of those, where the mean error is at most the mean bound
  double median_ratio = 0;  // of bound to error
};

// In the order of the rows; the error is limit_mae, to the same setting with the knob at its limit.
// Scenes without such a setting are left out.
std::vector<BoundCheck> check_bounds(const std::vector<RunRow>& rows);

}  // namespace amalgam::report
