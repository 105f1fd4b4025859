#include "bench/goals/goal_list.h"

#include "bench/goals/measures.h"
#include "bench/progress.h"

namespace amalgam::bench {
namespace {

using enum Comparison;

const std::vector<MeasuredGoal> kGoals{
    {{"trace-threads", "trace stage on 1 thread / on 2 threads", AtLeast, 1.8, ""},
     measure_trace_threads},
    {{"trace-replay", "trace stage / bare replay of its rays by Embree, same threads", AtMost, 1.25,
      ""},
     measure_trace_replay},
    {{"raster-passes", "all passes but trace, decode, encode / diffuse pass over all pixels",
      AtMost, 0.1, ""},
     measure_raster_passes},
    {{"thesis-rows", "our frames a second / the thesis's, lowest row of Table 6.1", AtLeast, 1.5,
      ""},
     measure_thesis_rows},
    {{"thesis-still", "the same on a tripod: nothing moves, only the camera's colors change",
      AtLeast, 1.5, ""},
     measure_thesis_still},
    {{"thesis-mirrors", "the same, lowest row of the mirror bunny", AtLeast, 2.0, ""},
     measure_thesis_mirrors},
    {{"hybrid", "whole-image ray tracing / hybrid, time of the same frame", AtLeast, 2.5, ""},
     measure_hybrid},
    {{"no-pose", "frame without a pose / full frame, time", AtMost, 0.01, ""}, measure_no_pose},
    {{"nothing-in-view", "frame with nothing virtual in view / full frame, time", AtMost, 0.01, ""},
     measure_nothing_in_view},
    {{"server-path", "frame over the network / sum of its stages without one", AtMost, 1.05, ""},
     measure_server_path},
    {{"two-clients", "frames a second of two clients on two scenes / of one", AtLeast, 1.6, ""},
     measure_two_clients},
    {{"nine-samples", "9 samples / 1 sample, time", AtMost, 7.0, ""}, measure_nine_samples},
    {{"adaptive", "adaptive samples / 9 samples, time, at SSIM >= .99", AtMost, 1.0 / 3.0, ""},
     measure_adaptive},
    {{"page-faults", "minor page faults of a frame in the steady state", Below, 200.0, "faults"},
     measure_page_faults},
    {{"session-memory", "resident memory for each further session", AtMost, 40.0, "MB"},
     measure_session_memory},
    {{"povray", "frame over the network / POV-Ray's trace time", AtMost, 1.0 / 25.0, ""},
     measure_povray},
    {{"governed", "SSIM of frames governed at 30 a second against full quality", AtLeast, 0.98, ""},
     measure_governed},
};

}  // namespace

const std::vector<MeasuredGoal>& all_goals() {
  return kGoals;
}

GoalLine measure(const MeasuredGoal& goal, GoalBench& bench) {
  say_progress(goal.goal.name + ": " + goal.goal.what);
  try {
    return {goal.goal, goal.measure(bench)};
  } catch (const MissingScene& missing) {
    return {goal.goal, NotMeasured{missing.what()}};
  } catch (const std::exception& error) {
    return {goal.goal, NotMeasured{std::string("failed: ") + error.what(), true}};
  }
}

Measurement to_measurement(const Ratio& ratio, const std::string& note) {
  return {.value = ratio.value, .low = ratio.low, .high = ratio.high, .note = note};
}

}  // namespace amalgam::bench
