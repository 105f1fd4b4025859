// The measurements behind the goals, each in the file of its name. All of them throw MissingScene
// where a scene is not there, and other exceptions only where measuring itself failed.
#pragma once

#include "bench/goal.h"
#include "bench/goals/goal_bench.h"
#include "bench/series.h"

namespace amalgam::bench {

// Value and spread of the ratio; the note begins with what was measured.
Measurement to_measurement(const Ratio& ratio, const std::string& note);

Outcome measure_trace_threads(GoalBench& bench);
Outcome measure_trace_replay(GoalBench& bench);
Outcome measure_raster_passes(GoalBench& bench);
Outcome measure_thesis_rows(GoalBench& bench);
Outcome measure_thesis_still(GoalBench& bench);
Outcome measure_thesis_mirrors(GoalBench& bench);
Outcome measure_hybrid(GoalBench& bench);
Outcome measure_no_pose(GoalBench& bench);
Outcome measure_nothing_in_view(GoalBench& bench);
Outcome measure_server_path(GoalBench& bench);
Outcome measure_two_clients(GoalBench& bench);
Outcome measure_nine_samples(GoalBench& bench);
Outcome measure_adaptive(GoalBench& bench);
Outcome measure_page_faults(GoalBench& bench);
Outcome measure_session_memory(GoalBench& bench);
Outcome measure_povray(GoalBench& bench);
Outcome measure_governed(GoalBench& bench);

}  // namespace amalgam::bench
