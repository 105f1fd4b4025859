// The cost of a frame by kind of work, and cost ratios between levels of quality.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "frame/frame.h"

namespace amalgam::frame {

// The time that a frame took, by the kinds of work that quality changes.
struct FrameCost {
  double trace = 0.0;   // ms: trace and refine
  double raster = 0.0;  // ms: passes over the rendered pixels
  double encode = 0.0;  // ms
  double other = 0.0;   // ms: work that quality does not change
  // Specular pixels as a share of all, [0, 1], to which the cost of tracing is proportional; 1 if
  // all pixels are traced.
  double specular = 0.0;

  double total() const { return trace + raster + encode + other; }
};

FrameCost frame_cost(const FrameStatistics& statistics);

// Cost ratios between levels of quality: estimated at first, then learned.
class RelativeCosts {
 public:
  // By level, the best first; in any unit, above 0 and never rising.
  explicit RelativeCosts(std::vector<double> costs) : costs_(std::move(costs)) {}

  // Cost of one level as a multiple of another's.
  double ratio(std::size_t to, std::size_t from) const { return costs_[to] / costs_[from]; }

  // ratio: the measured cost at `to` over that at `from`. Levels between the two take part of the
  // correction, levels beyond `to` all of it.
  void learn(std::size_t from, std::size_t to, double ratio);

 private:
  std::vector<double> costs_;
};

}  // namespace amalgam::frame
