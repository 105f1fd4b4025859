// The mask pass: kind and depth of the first surface that each sample sees (M_v and M_r).
#pragma once

#include <cstdint>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/upload_view.h"

namespace amalgam::passes {

// The mask on the GPU, for the diffuse pass.
struct DeviceMask {
  DeviceImage flags = nullptr;  // R8UI
  DeviceImage depth = nullptr;  // 32F, reversed
};

// Numbers of samples (not pixels).
struct SampleCounts {
  std::uint64_t total = 0;
  std::uint64_t surface = 0;
  std::uint64_t virtual_surface = 0;
  std::uint64_t specular = 0;
};

struct MaskInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
};

struct MaskOutputs {
  graph::Handle<DeviceMask> device;
  graph::Handle<SampleMask> mask;
  graph::Handle<SampleCounts> counts;
  graph::Handle<SpecularSamples> specular;  // absent: "no specular pixel in this frame"
  graph::Handle<DiffuseSamples> diffuse;    // absent: "no diffuse object in view"
};

MaskOutputs add_mask_pass(graph::FrameGraph& graph, const MaskInputs& in);

}  // namespace amalgam::passes
