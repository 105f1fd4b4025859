// Depth of the real objects alone, for the visibility test of look-ups.
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
  graph::Handle<SpecularSamples> specular;  // only traced rays make look-ups
};

struct RealDepthOutputs {
  // One value at the centre of each ideal pixel. Absent: "no real object in view", or without
  // specular samples.
  graph::Handle<RealDepth> depth;
};

RealDepthOutputs add_real_depth_pass(graph::FrameGraph& graph, const RealDepthInputs& in);

}  // namespace amalgam::passes
