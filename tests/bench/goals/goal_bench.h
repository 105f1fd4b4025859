// What measurements share: where scenes are, and what several goals are read from.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bench/bench_case.h"
#include "bench/goal.h"
#include "bench/thesis_result.h"

namespace amalgam::bench {

// Frame times with nine samples a pixel to one, and with adaptive ones to nine.
struct SampleCosts {
  Measurement nine, adaptive;
};

class GoalBench {
 public:
  GoalBench(const std::filesystem::path& scene_folder, int cores)
      : scenes_(scene_folder), cores_(cores) {}

  const BenchScenes& scenes() const { return scenes_; }
  int cores() const { return cores_; }

  // Table 6.1 anew; takes long the first time. Throws MissingScene.
  const std::vector<ThesisResult>& thesis();
  // Of the worse of two scenes. Throws MissingScene.
  const SampleCosts& samples();
  // What thesis() gave, if anything asked for it.
  const std::vector<ThesisResult>& measured_thesis() const { return thesis_; }

 private:
  BenchScenes scenes_;
  int cores_;
  std::vector<ThesisResult> thesis_;
  std::optional<SampleCosts> samples_;
};

}  // namespace amalgam::bench
