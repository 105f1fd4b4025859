// Replaces the trace pass while nothing moves: resolves an earlier frame's paths with the colors of
// this frame's camera image.
#pragma once

#include <memory>

#include "graph/frame_graph.h"
#include "passes/image/decode.h"
#include "trace/tracer.h"

namespace amalgam::passes {

using KeptPaths = std::shared_ptr<const trace::TracedPaths>;

struct LookUpInputs {
  graph::Handle<KeptPaths> paths;
  graph::Handle<CameraImage> camera_image;
  graph::Handle<scene::ToneMap> tone_map;
  scene::RealSurfaces real_surfaces = scene::RealSurfaces::Ratio;
};

graph::Handle<trace::TraceResult> add_look_up_pass(graph::FrameGraph& graph,
                                                   const LookUpInputs& in);

}  // namespace amalgam::passes
