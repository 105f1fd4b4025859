#include "passes/image/exposure.h"

#include <cmath>

namespace amalgam::passes {

float ExposureMemory::update(std::optional<float> reading) {
  constexpr float kShare = 0.25f;
  if (!reading) return last_.value_or(1.0f);
  last_ = last_ ? *last_ * std::pow(*reading / *last_, kShare) : *reading;
  return *last_;
}

graph::Handle<float> add_exposure_pass(graph::FrameGraph& graph, const ExposureInputs& in) {
  if (in.fixed) {
    graph.note_left_out("exposure", "the exposure is fixed");
    return graph.import("exposure", *in.fixed);
  }
  graph::Builder builder = graph.add_pass("exposure");
  builder.needs(in.camera_image);
  builder.uses(in.grid);
  const auto out = builder.writes<float>("exposure");
  builder.runs([in, out](const graph::Access& access) {
    const MeterGrid* grid = access.find(in.grid);
    std::optional<float> reading;
    if (grid != nullptr) {
      reading = meter_exposure(*grid, in.ideal, in.camera, access.get(in.camera_image).pixels);
    }
    access.set(out, in.memory.update(reading));
  });
  return out;
}

}  // namespace amalgam::passes
