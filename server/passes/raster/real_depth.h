// Depth of the real objects alone, for the look-up's question "is this what the camera sees
// there?".
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/mask.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/upload_view.h"

namespace amalgam::passes {

struct RealDepthInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
  graph::Handle<SpecularSamples> specular;  // only traced rays look up
};

struct RealDepthOutputs {
  // One value an ideal pixel, at its centre. Absent: "no real object in view", or for want of
  // specular samples.
  graph::Handle<RealDepth> depth;
};

RealDepthOutputs add_real_depth_pass(graph::FrameGraph& graph, const RealDepthInputs& in);

}  // namespace amalgam::passes
