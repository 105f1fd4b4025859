// All goals in their order, each with how it is measured.
#pragma once

#include <vector>

#include "bench/goal.h"
#include "bench/goals/goal_bench.h"

namespace amalgam::bench {

struct MeasuredGoal {
  Goal goal;
  Outcome (*measure)(GoalBench& bench);
};

const std::vector<MeasuredGoal>& all_goals();

// Measures. A scene that is missing makes the outcome NotMeasured; so does what goes wrong, so that
// the other goals are measured all the same.
GoalLine measure(const MeasuredGoal& goal, GoalBench& bench);

}  // namespace amalgam::bench
