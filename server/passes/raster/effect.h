// Reads the shaded tiles back and finds whether anything virtual shows in them. If not, the frame
// may go back unchanged.
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/diffuse.h"
#include "passes/raster/raster_context.h"

namespace amalgam::passes {

// Exists only if some diffuse sample is virtual or differs between I_m and I_r. Owned by
// RasterTargets until the end of the frame.
struct DiffuseEffect {
  const ShadedTiles* tiles = nullptr;
};

// Copies the tiles that show something virtual, for a later equal frame.
ShadedTiles copy_what_shows(const ShadedTiles& shaded, const RenderView& view);

struct EffectInputs {
  const RasterContext& raster;
  const RenderView& view;
  DiffuseOutputs diffuse;
  graph::Handle<ReachedTiles> reached;
};

struct EffectOutputs {
  // Absent: "nothing virtual has an effect on this frame", or for the reason for which the diffuse
  // images are absent.
  graph::Handle<DiffuseEffect> effect;
};

EffectOutputs add_effect_pass(graph::FrameGraph& graph, const EffectInputs& in);

}  // namespace amalgam::passes
