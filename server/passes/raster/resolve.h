// Resolves the diffuse samples to the rasteriser's share of the layers (core/layers.h): of each
// sample of a pixel
//
//   virtual    TM(I_m) to A, and coverage
//   real       what virtual objects change of its light to Q and D (scene/light/real_surfaces.h)
//
// averaged over the n x n samples. One tone map for both images (numerics A4). Specular samples and
// samples without a surface add zero. Only tiles that show something virtual exist.
#pragma once

#include <cstdint>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/effect.h"
#include "scene/light/real_surfaces.h"

namespace amalgam::passes {

struct ResolveInputs {
  const RenderView& view;
  graph::Handle<DiffuseEffect> effect;  // if absent, all layers would be zero
  graph::Handle<scene::ToneMap> tone_map;
  scene::RealSurfaces real_surfaces;
};

struct ResolveOutputs {
  graph::Handle<Layers> layers;
  graph::Handle<std::uint64_t> nonfinite;  // channel values replaced by 0
};

ResolveOutputs add_resolve_pass(graph::FrameGraph& graph, const ResolveInputs& in);

}  // namespace amalgam::passes
