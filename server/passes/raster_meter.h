// The exposure meter's grid from the rasterised I_r.
#pragma once

#include "graph/frame_graph.h"
#include "passes/exposure_meter.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// real: I_r with alpha 1 on real surfaces, a texel a sample.
graph::Handle<MeterGrid> add_raster_meter_pass(graph::FrameGraph& graph, const RenderView& view,
                                               graph::Handle<DeviceImage> real);

}  // namespace amalgam::passes
