#include "passes/image/warp.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

namespace amalgam::passes {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

// Places further out lie outside any image, and their integers would overflow.
bool is_near(const glm::vec2& at) {
  return std::abs(at.x) < 1e6f && std::abs(at.y) < 1e6f;
}

WarpMap::Bounds bounds_of(const common::Image<glm::vec2>& at, glm::ivec2 first, glm::ivec2 end) {
  WarpMap::Bounds bounds{glm::vec2(1e6f), glm::vec2(-1e6f)};
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      const glm::vec2& place = at.at(x, y);
      if (!is_near(place)) continue;
      bounds.low = glm::min(bounds.low, place);
      bounds.high = glm::max(bounds.high, place);
    }
  }
  return bounds;
}

core::LayerPixel mix(const core::LayerPixel& a, const core::LayerPixel& b, float t) {
  return {glm::mix(a.over, b.over, t), glm::mix(a.difference, b.difference, t),
          glm::mix(a.relative_change, b.relative_change, t)};
}

class LayerSampler {
 public:
  explicit LayerSampler(const Layers& layers) : layers_(layers) {}

  core::LayerPixel bilinear(const glm::vec2& at) const {
    const float floor_x = std::floor(at.x), floor_y = std::floor(at.y);
    const int x = static_cast<int>(floor_x), y = static_cast<int>(floor_y);
    const float fx = at.x - floor_x, fy = at.y - floor_y;
    // Usually all four lie in one tile.
    const bool inside = x >= 0 && y >= 0 && x + 1 < layers_.size().x && y + 1 < layers_.size().y;
    if (inside && x % core::kTileSide != core::kTileSide - 1 &&
        y % core::kTileSide != core::kTileSide - 1) {
      const core::LayerTile* tile = layers_.find(layers_.grid().tile_of(x, y));
      if (tile == nullptr) return {};
      const std::size_t upper = core::LayerTile::index(x, y), lower = upper + core::kTileSide;
      const auto& pixels = tile->pixels;
      return mix(mix(pixels[upper], pixels[upper + 1], fx),
                 mix(pixels[lower], pixels[lower + 1], fx), fy);
    }
    return mix(mix(texel(x, y), texel(x + 1, y), fx), mix(texel(x, y + 1), texel(x + 1, y + 1), fx),
               fy);
  }

  // Whether a tile exists that bilinear() would read for places within the bounds.
  bool may_show(const WarpMap::Bounds& bounds) const {
    const core::TileGrid& grid = layers_.grid();
    const auto tile = [](float pixel, int tiles) {
      return std::clamp(static_cast<int>(std::floor(pixel)) / core::kTileSide, 0, tiles - 1);
    };
    const glm::ivec2 tiles = grid.tiles();
    for (int y = tile(bounds.low.y, tiles.y); y <= tile(bounds.high.y + 1.0f, tiles.y); ++y) {
      for (int x = tile(bounds.low.x, tiles.x); x <= tile(bounds.high.x + 1.0f, tiles.x); ++x) {
        if (layers_.find(grid.index({x, y})) != nullptr) return true;
      }
    }
    return false;
  }

 private:
  core::LayerPixel texel(int x, int y) const {
    if (x < 0 || y < 0 || x >= layers_.size().x || y >= layers_.size().y) return {};
    return layers_.at(x, y);
  }

  const Layers& layers_;
};

// Maps places in the ideal image of full size to places in the layers.
class Scaling {
 public:
  explicit Scaling(float scale)
      : scale_(scale), offset_(scale < 1.0f ? 0.5f * scale - 0.5f + kScaledBorder : 0.0f) {}
  glm::vec2 operator()(const glm::vec2& at) const { return at * scale_ + offset_; }

 private:
  float scale_, offset_;  // at scale 1 they change no bit
};

}  // namespace

WarpMap make_warp_map(const common::CameraModel& camera, const common::CameraModel& ideal) {
  WarpMap map{common::Image<glm::vec2>(camera.width, camera.height, glm::vec2(kNowhere)), {}};
  tbb::parallel_for(0, camera.height, [&](int y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto direction = common::pixel_direction(camera, {x, y});
      const auto at = direction ? common::project(ideal, *direction) : std::nullopt;
      if (at) map.at.at(x, y) = glm::vec2(*at);
    }
  });
  const core::TileGrid grid(map.at.size());
  map.tiles.reserve(grid.count());
  for (std::size_t tile = 0; tile < grid.count(); ++tile) {
    map.tiles.push_back(bounds_of(map.at, grid.first_pixel(tile), grid.end_pixel(tile)));
  }
  return map;
}

common::CameraModel scaled_camera(const common::CameraModel& ideal, double scale) {
  if (scale >= 1.0) return ideal;
  common::CameraModel scaled = ideal;
  scaled.width = static_cast<int>(std::ceil(ideal.width * scale)) + 2 * kScaledBorder;
  scaled.height = static_cast<int>(std::ceil(ideal.height * scale)) + 2 * kScaledBorder;
  scaled.fx *= scale;
  scaled.fy *= scale;
  // Pixel centres are integers, so that the picture begins at -0.5.
  scaled.cx = common::scaled_position(ideal.cx, scale) + kScaledBorder;
  scaled.cy = common::scaled_position(ideal.cy, scale) + kScaledBorder;
  return scaled;
}

Layers warp_layers(const Layers& layers, const LayerPlacement& placement) {
  Layers warped(placement.size);
  const Scaling scaling(placement.scale);
  const LayerSampler sampler(layers);
  const WarpMap* lens = placement.lens;
  tbb::parallel_for(std::size_t{0}, warped.grid().count(), [&](std::size_t tile) {
    const glm::ivec2 first = warped.grid().first_pixel(tile), end = warped.grid().end_pixel(tile);
    const WarpMap::Bounds bounds =
        lens != nullptr ? lens->tiles[tile]
                        : WarpMap::Bounds{glm::vec2(first), glm::vec2(end - glm::ivec2(1))};
    if (bounds.low.x > bounds.high.x) return;
    if (!sampler.may_show({scaling(bounds.low), scaling(bounds.high)})) return;
    core::LayerTile* out = nullptr;
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        const glm::vec2 at = lens != nullptr ? lens->at.at(x, y) : glm::vec2(x, y);
        if (!is_near(at)) continue;
        const core::LayerPixel pixel = sampler.bilinear(scaling(at));
        if (pixel.is_zero()) continue;
        if (out == nullptr) out = &warped.make(tile);
        out->at(x, y) = pixel;
      }
    }
  });
  return warped;
}

graph::Handle<Layers> add_warp_pass(graph::FrameGraph& graph, graph::Handle<Layers> layers,
                                    const LayerPlacement& placement) {
  graph::Builder builder = graph.add_pass("warp");
  builder.needs(layers);
  const auto out = builder.writes<Layers>("warped layers");
  builder.runs([layers, out, placement](const graph::Access& access) {
    Layers warped = warp_layers(access.get(layers), placement);
    if (warped.is_zero()) {
      access.leave_empty(out, "nothing virtual has an effect on this frame");
    } else {
      access.set(out, std::move(warped));
    }
  });
  return out;
}

}  // namespace amalgam::passes
