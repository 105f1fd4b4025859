// Resolves the diffuse samples to the rasteriser's share of the layers (eq. 4.5 per sample, then
// averaged over the n x n samples of a pixel):
//
//   over       = mean(M_v TM(I_m)),  coverage = mean(M_v)
//   difference = mean((1 - M_v) (TM(I_m) - TM(I_r)))
//
// with TM of scene/light/tone_map.h and one exposure for both images (numerics A4). Specular
// samples and samples without a surface add zero. Only tiles that show something virtual exist.
#pragma once

#include <cstdint>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/effect.h"

namespace amalgam::passes {

struct ResolveInputs {
  const RenderView& view;
  graph::Handle<DiffuseEffect> effect;  // if absent, all layers would be zero
  graph::Handle<float> exposure;
};

struct ResolveOutputs {
  graph::Handle<Layers> layers;
  graph::Handle<std::uint64_t> nonfinite;  // channel values replaced by 0
};

ResolveOutputs add_resolve_pass(graph::FrameGraph& graph, const ResolveInputs& in);

}  // namespace amalgam::passes
