// Which tiles of the picture can show anything virtual on diffuse surfaces: those with a virtual
// diffuse sample, and those with a real one that the shadow of a virtual caster may reach. All
// others differ in nothing between I_m and I_r, to the bit, and are neither shaded nor read back.
//
// A tile's real surfaces lie in the piece of its frustum between their least and greatest depth.
// The piece is seen from each light, grown by what a shadow look-up may move (shaders/shadow.glsl:
// its lift along the normal, and the filter), and compared with the nearest casters there.
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

// Depths along the camera's z of a tile's real diffuse samples, metres; nearest > farthest: none.
struct DepthRange {
  double nearest = 1.0, farthest = 0.0;
  bool is_empty() const { return nearest > farthest; }
};

// Layers of shadow maps in which something virtual casts that a tile is tested against; a frame
// with more takes every tile with a real surface for reached.
constexpr std::size_t kMostLayersTested = 96;

// Lights as bits; all bits where there are more than eight lights.
using LightSet = std::uint8_t;
static_assert(gl::kFewSuns <= 8 * sizeof(LightSet));
constexpr LightSet kAllLights = 0xFF;

// For each tile the lights by which a shadow of the casters may fall on something between the
// depths.
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
