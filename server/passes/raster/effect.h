// Reads the shaded tiles back and asks whether anything virtual shows in them at all: if not, the
// frame may go back as it came.
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/diffuse.h"
#include "passes/raster/raster_context.h"

namespace amalgam::passes {

// Exists only if some diffuse sample is virtual, or differs between I_m and I_r. Owned by the
// RasterTargets, until the end of the frame.
struct DiffuseEffect {
  const ShadedTiles* tiles = nullptr;
};

// A copy of the tiles that show something virtual, for a later frame in which nothing has moved.
ShadedTiles copy_what_shows(const ShadedTiles& shaded, const RenderView& view);

struct EffectInputs {
  const RasterContext& raster;
  const RenderView& view;
  DiffuseOutputs diffuse;
  graph::Handle<ReachedTiles> reached;
};

struct EffectOutputs {
  // Or absent: "nothing virtual has an effect on this frame", or for the reason that there are no
  // diffuse images.
  graph::Handle<DiffuseEffect> effect;
};

EffectOutputs add_effect_pass(graph::FrameGraph& graph, const EffectInputs& in);

}  // namespace amalgam::passes
