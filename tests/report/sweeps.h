// The settings that are measured: one knob at a time around the default, and a few settings of all
// knobs together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/sweep_point.h"

namespace amalgam::report {

// How much is spent on the references.
struct ReferenceQuality {
  int samples_per_side = 16;
  int max_depth = 64;
  double importance_cutoff = 1e-4;  // of the best picture
  double limit_cutoff = 1e-6;       // of a knob's limit: one sample a pixel allows less
  int lights = 1024;                // of the median cut, where the number of lights is swept
};

ReferenceQuality full_quality();
ReferenceQuality quick_quality();

struct SweepOptions {
  bool quick = false;
  int threads = 0;  // 0: the bench's default
  float exposure = 1.0f;
  // For stiff scenes: only the sweeps of depth and cut-off.
  bool stiff = false;
  // ReportScene::bounce_reflectance: depths and cut-offs are then chosen by it.
  std::optional<double> bounce_reflectance{};
};

// In the order of their sweeps. Each sweep has the default among its points.
std::vector<SweepPoint> make_sweeps(const SweepOptions& options);

// Of all sweeps, in order.
std::vector<std::string> sweep_names();

// The exact reference of the renderer's default settings, as sweeps compare with.
ReferenceSpec best_reference(const ReferenceQuality& quality);

}  // namespace amalgam::report
