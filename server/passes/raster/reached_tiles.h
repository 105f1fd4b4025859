// Finds the tiles that can show anything virtual on diffuse surfaces: those with a virtual diffuse
// sample, and those with a real one that a virtual caster's shadow may reach. In all others I_m and
// I_r are equal to the bit, and they are neither shaded nor read back.
//
// A tile's real surfaces lie in its frustum between their least and greatest depth. This piece is
// projected to each light's shadow map and grown by the reach of a shadow look-up
// (shaders/shadow.glsl: the filter, and the receiver's plane within it). Its depth is compared with
// that of the nearest casters there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/caster_cells.h"
#include "passes/raster/mask.h"
#include "passes/raster/shadow_maps.h"

namespace amalgam::passes {

// Camera-frame z of a tile's real diffuse samples, metres; nearest > farthest: no samples.
struct DepthRange {
  double nearest = 1.0, farthest = 0.0;
  bool is_empty() const { return nearest > farthest; }
};

// Most shadow-map layers with virtual casters that tiles are tested against. With more, every tile
// with a real diffuse surface counts as reached.
constexpr std::size_t kMostLayersTested = 96;

// A bit for each light; all bits if there are more than eight lights.
using LightSet = std::uint8_t;
static_assert(gl::kFewSuns <= 8 * sizeof(LightSet));
constexpr LightSet kAllLights = 0xFF;

// For each tile, the lights whose shadows of the casters may reach a point between the depths.
std::vector<LightSet> tiles_in_shadow(const RenderView& view, const ShadowLayout& layout,
                                      std::span<const CasterCells* const> casters,
                                      std::span<const DepthRange> depths);

// Tiles of the ideal image, ascending.
struct ReachedTiles {
  std::vector<std::size_t> tiles;
  std::vector<LightSet> lights;  // of all tiles of the ideal image
};

struct ReachedTilesInputs {
  const RasterContext& raster;
  const RenderView& view;
  MaskOutputs mask;
  ShadowMapOutputs shadows;
  bool all = false;  // leave nothing out
};

// Absent: "no diffuse object in view", or "nothing virtual has an effect on this frame".
graph::Handle<ReachedTiles> add_reached_tiles_pass(graph::FrameGraph& graph,
                                                   const ReachedTilesInputs& in);

}  // namespace amalgam::passes
