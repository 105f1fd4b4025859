// Frames a second against Table 6.1 of the thesis.
#include <algorithm>
#include <limits>

#include "bench/goals/measures.h"
#include "bench/goals/thesis_meter.h"

namespace amalgam::bench {
namespace {

template <typename Counts>
Measurement lowest_row(const std::vector<ThesisResult>& results, const Counts& counts) {
  Measurement measured;
  measured.value = std::numeric_limits<double>::infinity();
  int rows = 0;
  for (const ThesisResult& result : results) {
    if (!is_held_to_goal(result.row) || !counts(result.row)) continue;
    measured.value = std::min(measured.value, result.ratio());
    measured.high = std::max(measured.high, result.ratio());
    ++rows;
  }
  measured.low = measured.value;
  measured.note = std::to_string(rows) + " rows, below";
  return measured;
}

}  // namespace

const std::vector<ThesisResult>& GoalBench::thesis() {
  if (thesis_.empty()) {
    ThesisMeter meter(scenes_);
    std::vector<ThesisResult> results;  // all rows or none
    for (const ThesisRow& row : thesis_table()) results.push_back(meter.measure(row));
    thesis_ = std::move(results);
  }
  return thesis_;
}

Outcome measure_thesis_rows(GoalBench& bench) {
  return lowest_row(bench.thesis(), [](const ThesisRow&) { return true; });
}

Outcome measure_thesis_still(GoalBench& bench) {
  Measurement measured;
  measured.value = std::numeric_limits<double>::infinity();
  int rows = 0, not_kept = 0;
  for (const ThesisResult& result : bench.thesis()) {
    if (!is_held_to_goal(result.row)) continue;
    if (!result.still_frames_per_second) {
      ++not_kept;
      continue;
    }
    const double ratio = *result.still_frames_per_second / result.row.frames_per_second;
    measured.value = std::min(measured.value, ratio);
    measured.high = std::max(measured.high, ratio);
    ++rows;
  }
  measured.low = measured.value;
  measured.note = std::to_string(rows) + " rows, below; " + std::to_string(not_kept) +
                  " of more samples than are kept";
  return measured;
}

Outcome measure_thesis_mirrors(GoalBench& bench) {
  return lowest_row(bench.thesis(),
                    [](const ThesisRow& row) { return row.scene == ThesisScene::MirrorBunny; });
}

}  // namespace amalgam::bench
