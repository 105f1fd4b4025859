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

// Measures; a scene that is missing makes the outcome NotMeasured. Throws whatever else goes wrong.
GoalLine measure(const MeasuredGoal& goal, GoalBench& bench);

}  // namespace amalgam::bench
