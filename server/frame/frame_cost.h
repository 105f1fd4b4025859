// The time that a frame took, by the kinds of work that quality changes.
#pragma once

#include "frame/frame.h"

namespace amalgam::frame {

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

}  // namespace amalgam::frame
