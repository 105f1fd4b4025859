// The exposure meter's grid from rasterised real surfaces. A few thousand samples are shaded for it
// alone, because the diffuse pass only shades where something virtual may show.
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/meter_grid.h"
#include "passes/raster/diffuse.h"

namespace amalgam::passes {

struct RasterMeterInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
  MaskOutputs mask;
  ShadowMapOutputs shadows;
};

// Absent: "no diffuse object in view".
graph::Handle<MeterGrid> add_raster_meter_pass(graph::FrameGraph& graph,
                                               const RasterMeterInputs& in);

}  // namespace amalgam::passes
