#include "passes/raster/reached_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "common/pose.h"
#include "core/tile_grid.h"

namespace amalgam::passes {
namespace {

// The projection of camera-frame points to a layer of the shadow maps.
struct LayerView {
  std::size_t layer = 0;
  LightSet light = 0;
  bool perspective = false;
  glm::dmat4 clip_from_camera{1.0};
  double texel = 0.0;     // side of a texel, metres (perspective: at 1 m)
  glm::dvec4 slope{0.0};  // the most that a clip coordinate changes in a metre
};

std::vector<LayerView> layers_with_casters(const RenderView& view, const ShadowLayout& layout,
                                           std::span<const CasterCells* const> casters) {
  const glm::dmat4 world_from_camera = common::rigid_inverse(view.scene.camera_from_world);
  std::vector<LayerView> layers;
  const bool few = layout.gpu_lights.size() <= gl::kFewSuns;
  for (std::size_t l = 0; l < layout.gpu_lights.size(); ++l) {
    const gl::GpuLight& light = layout.gpu_lights[l];
    const auto light_bit = static_cast<LightSet>(few ? 1u << l : kAllLights);
    for (std::size_t i = 0; i < light.layer_count; ++i) {
      const std::size_t layer = light.first_layer + i;
      if (std::all_of(casters.begin(), casters.end(),
                      [&](const CasterCells* cells) { return cells->is_empty(layer); })) {
        continue;
      }
      const glm::dmat4 clip(layout.layers[layer].clip_from_world);
      LayerView seen{layer, light_bit, layout.layers[layer].perspective != 0,
                     clip * world_from_camera, static_cast<double>(layout.texels[l])};
      for (int row = 0; row < 4; ++row) {
        seen.slope[row] = glm::length(glm::dvec3(clip[0][row], clip[1][row], clip[2][row]));
      }
      layers.push_back(seen);
    }
  }
  return layers;
}

// The corners of the part of a tile's frustum between two depths, in the camera's frame.
std::array<glm::dvec3, 8> corners(const common::CameraModel& ideal, glm::ivec2 first,
                                  glm::ivec2 end, const DepthRange& depths) {
  constexpr double kRounding = 1e-5;  // relative: of float depths, and of interpolated positions
  std::array<glm::dvec3, 8> corners{};
  for (unsigned i = 0; i < 8; ++i) {
    const double u = ((i & 1) != 0 ? end.x : first.x) - 0.5;
    const double v = ((i & 2) != 0 ? end.y : first.y) - 0.5;
    const double z =
        (i & 4) != 0 ? depths.farthest * (1.0 + kRounding) : depths.nearest * (1.0 - kRounding);
    corners[i] = z * glm::dvec3((u - ideal.cx) / ideal.fx, (v - ideal.cy) / ideal.fy, 1.0);
  }
  return corners;
}

// The part of a layer that look-ups for points between the corners may read, and the depth that
// they compare with.
struct Footprint {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};  // in units of the map's side
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
  double depth = std::numeric_limits<double>::infinity();  // reversed, the least
  bool is_visible = true;                                  // from the light, through this layer
};

Footprint footprint_of(const LayerView& layer, const std::array<glm::dvec3, 8>& corners, int size) {
  std::array<glm::dvec4, 8> clip{};
  double farthest = 0.0;
  for (std::size_t i = 0; i < clip.size(); ++i) {
    clip[i] = layer.clip_from_camera * glm::dvec4(corners[i], 1.0);
    farthest = std::max(farthest, clip[i].w);
  }
  // A look-up follows the receiver's plane to the centres of texels around it, at most a texel away
  // on each axis, and no steeper than shaders/shadow.glsl lets it. A little more is for rounding.
  const double steepest = std::sqrt(2.0) * layer.texel / gl::kLeastShadowCosine;
  const double rounding =
      0.1 * layer.texel * (layer.perspective ? 2.7 * std::max(farthest, 0.0) : 1.0);
  const glm::dvec4 grow = rounding * layer.slope;
  Footprint seen;
  if (!layer.perspective) {
    for (const glm::dvec4& c : clip) {
      seen.low = glm::min(seen.low, glm::dvec2(c) - glm::dvec2(grow));
      seen.high = glm::max(seen.high, glm::dvec2(c) + glm::dvec2(grow));
      seen.depth = std::min(seen.depth, c.z - grow.z - steepest * layer.slope.z);
    }
  } else {
    const double border = 1.0 + 8.0 / size;  // with room for the filter
    const auto all = [&](const auto& outside) {
      return std::all_of(clip.begin(), clip.end(), outside);
    };
    // Points wholly beyond the border find nothing.
    if (all([&](const glm::dvec4& c) { return c.w + grow.w <= 0.0; }) ||
        all([&](const glm::dvec4& c) { return c.x - grow.x > border * c.w + 2.0 * grow.w; }) ||
        all([&](const glm::dvec4& c) { return c.x + grow.x < -border * c.w - 2.0 * grow.w; }) ||
        all([&](const glm::dvec4& c) { return c.y - grow.y > border * c.w + 2.0 * grow.w; }) ||
        all([&](const glm::dvec4& c) { return c.y + grow.y < -border * c.w - 2.0 * grow.w; })) {
      seen.is_visible = false;
      return seen;
    }
    for (const glm::dvec4& c : clip) {
      seen.depth =
          std::min(seen.depth, std::max(1.0 - steepest, 0.0) * kNearPlane / (farthest + grow.w));
      const double nearest_w = c.w - grow.w;
      if (!(nearest_w > 1e-6)) {  // beside or behind the light: anywhere in the map
        seen.low = glm::dvec2(-1.0);
        seen.high = glm::dvec2(1.0);
        break;
      }
      for (const double w : {nearest_w, c.w + grow.w}) {
        seen.low = glm::min(seen.low, (glm::dvec2(c) - glm::dvec2(grow)) / w);
        seen.high = glm::max(seen.high, (glm::dvec2(c) + glm::dvec2(grow)) / w);
      }
    }
  }
  // The filter reads one texel around. In units of the opaque map, a glass texel is two, or three
  // if the size is odd.
  const double filter = 4.0 / size;
  seen.low = 0.5 * seen.low + 0.5 - filter;
  seen.high = 0.5 * seen.high + 0.5 + filter;
  return seen;
}

bool is_in_shadow(const LayerView& layer, const std::array<glm::dvec3, 8>& corners, int size,
                  std::span<const CasterCells* const> casters) {
  const Footprint seen = footprint_of(layer, corners, size);
  if (!seen.is_visible) return false;
  return std::any_of(casters.begin(), casters.end(), [&](const CasterCells* cells) {
    const double nearest = cells->nearest_depth(layer.layer, seen.low, seen.high);
    return nearest > 0.0 && !(nearest <= seen.depth);
  });
}

// The depth range of each tile's real diffuse samples.
std::vector<DepthRange> depth_ranges(const SampleMask& mask, const common::Image32f& depth,
                                     const RenderView& view) {
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  const int n = view.samples_per_side;
  std::vector<DepthRange> ranges(grid.count());
  tbb::parallel_for(std::size_t{0}, grid.count(), [&](std::size_t tile) {
    if ((mask.tiles[tile] & SampleMask::kAnyRealDiffuse) == 0) return;
    const glm::ivec2 first = grid.first_pixel(tile) * n, end = grid.end_pixel(tile) * n;
    float low = std::numeric_limits<float>::infinity(), high = 0.0f;  // reversed depths
    for (int y = first.y; y < end.y; ++y) {
      const std::uint8_t* flags = &mask.flags.at(first.x, y);
      const float* depths = &depth.at(first.x, y);
      for (int x = 0; x < end.x - first.x; ++x) {
        const bool counts = flags[x] == SampleMask::kSurface;
        low = std::min(low, counts ? depths[x] : std::numeric_limits<float>::infinity());
        high = std::max(high, counts ? depths[x] : 0.0f);
      }
    }
    ranges[tile] = {kNearPlane / high,
                    low > 0.0f ? kNearPlane / low : std::numeric_limits<double>::infinity()};
  });
  return ranges;
}

ReachedTiles all_tiles(const SampleMask& mask) {
  ReachedTiles reached{std::vector<std::size_t>(mask.tiles.size()),
                       std::vector<LightSet>(mask.tiles.size(), kAllLights)};
  std::iota(reached.tiles.begin(), reached.tiles.end(), std::size_t{0});
  return reached;
}

ReachedTiles find_reached_tiles(const ReachedTilesInputs& in, const graph::Access& access) {
  const SampleMask& mask = access.get(in.mask.mask);
  if (in.all) return all_tiles(mask);
  std::vector<const CasterCells*> casters;
  for (const CasterClass caster : {CasterClass::VirtualOpaque, CasterClass::VirtualGlass}) {
    const ShadowMap* map = access.find(in.shadows.maps[static_cast<std::size_t>(caster)]);
    if (map != nullptr) casters.push_back(map->cells.get());
  }
  std::vector<LightSet> shadowed(mask.tiles.size());
  if (!casters.empty()) {
    const gl::Texture& device = *access.get(in.mask.device).depth;
    common::Image32f& depth = in.raster.targets.depth_here;
    if (depth.size() != device.size()) depth = common::Image32f(device.size().x, device.size().y);
    device.read(depth.data(), depth.pixels().size_bytes());
    shadowed = tiles_in_shadow(in.view, access.get(in.shadows.lights)->layout, casters,
                               depth_ranges(mask, depth, in.view));
  }
  ReachedTiles reached;
  for (std::size_t tile = 0; tile < mask.tiles.size(); ++tile) {
    const bool shows_virtual = (mask.tiles[tile] & SampleMask::kAnyVirtualDiffuse) != 0;
    // A virtual surface may lie in the shadow of any other object.
    if (shows_virtual) shadowed[tile] = kAllLights;
    if (shadowed[tile] != 0) reached.tiles.push_back(tile);
  }
  reached.lights = std::move(shadowed);
  return reached;
}

}  // namespace

std::vector<LightSet> tiles_in_shadow(const RenderView& view, const ShadowLayout& layout,
                                      std::span<const CasterCells* const> casters,
                                      std::span<const DepthRange> depths) {
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  const std::vector<LayerView> layers = layers_with_casters(view, layout, casters);
  const bool tests = layers.size() <= kMostLayersTested;
  std::vector<LightSet> shadowed(grid.count());
  tbb::parallel_for(std::size_t{0}, grid.count(), [&](std::size_t tile) {
    if (depths[tile].is_empty() || layers.empty()) return;
    if (!tests || !std::isfinite(depths[tile].farthest)) {
      shadowed[tile] = kAllLights;
      return;
    }
    const auto piece =
        corners(view.ideal, grid.first_pixel(tile), grid.end_pixel(tile), depths[tile]);
    for (const LayerView& layer : layers) {
      if ((shadowed[tile] & layer.light) == layer.light) continue;
      if (is_in_shadow(layer, piece, layout.size, casters)) shadowed[tile] |= layer.light;
    }
  });
  return shadowed;
}

graph::Handle<ReachedTiles> add_reached_tiles_pass(graph::FrameGraph& graph,
                                                   const ReachedTilesInputs& in) {
  graph::Builder builder = graph.add_pass("reached tiles");
  builder.needs(in.mask.diffuse);
  builder.needs(in.mask.mask);
  builder.needs(in.mask.device);
  builder.needs(in.shadows.lights);
  for (const auto& map : in.shadows.maps) builder.uses(map);
  const auto out = builder.writes<ReachedTiles>("reached tiles");
  builder.runs([in, out](const graph::Access& access) {
    ReachedTiles reached = find_reached_tiles(in, access);
    if (reached.tiles.empty()) {
      access.leave_empty(out, "nothing virtual has an effect on this frame");
    } else {
      access.set(out, std::move(reached));
    }
  });
  return out;
}

}  // namespace amalgam::passes
