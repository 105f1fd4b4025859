// One exposure for both images of a frame (numerics A4): fixed, or metered and smoothed over time.
#pragma once

#include <optional>

#include "graph/frame_graph.h"
#include "passes/image/decode.h"
#include "passes/image/exposure_meter.h"

namespace amalgam::passes {

// A view's exposure from frame to frame.
class ExposureMemory {
 public:
  // Returns the first reading unchanged, then moves a quarter of the way (in stops) towards each
  // later reading. Without a reading the last value stays; 1 before any.
  float update(std::optional<float> reading);

 private:
  std::optional<float> last_;
};

struct ExposureInputs {
  std::optional<float> fixed;  // if set, nothing else is read
  const common::CameraModel& camera;
  const common::CameraModel& ideal;
  graph::Handle<MeterGrid> grid;  // may be absent: no real surface in view
  graph::Handle<CameraImage> camera_image;
  ExposureMemory& memory;
};

graph::Handle<float> add_exposure_pass(graph::FrameGraph& graph, const ExposureInputs& in);

}  // namespace amalgam::passes
