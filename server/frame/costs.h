// What frames cost: one frame by kind of work, and how that changes from level to level of quality.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "frame/frame.h"

namespace amalgam::frame {

// By the kinds of work that quality changes.
struct FrameCost {
  double trace = 0.0;   // ms: trace and refine
  double raster = 0.0;  // ms: passes over the rendered pixels
  double encode = 0.0;  // ms
  double other = 0.0;   // ms: whatever quality does not change
  // Specular pixels as a share of all [0, 1], or 1 where all are traced: what tracing is paid for.
  double specular = 0.0;

  double total() const { return trace + raster + encode + other; }
};

FrameCost frame_cost(const FrameStatistics& statistics);

// How costs change from level to level of quality: guessed at first, then learned.
class RelativeCosts {
 public:
  // By level, the best first; of any unit, above 0 and never rising.
  explicit RelativeCosts(std::vector<double> costs) : costs_(std::move(costs)) {}

  // Cost of one level as a multiple of another's.
  double ratio(std::size_t to, std::size_t from) const { return costs_[to] / costs_[from]; }

  // A change of level changed the cost to so many times what it was. Levels between share the
  // correction, those beyond take it over whole.
  void learn(std::size_t from, std::size_t to, double ratio);

 private:
  std::vector<double> costs_;
};

}  // namespace amalgam::frame
