#include "passes/warp.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace amalgam::passes {
namespace {

template <typename Pixel, typename At>
Pixel bilinear(glm::ivec2 size, const At& pixel_at, const glm::vec2& at) {
  const float floor_x = std::floor(at.x), floor_y = std::floor(at.y);
  const int x = static_cast<int>(floor_x), y = static_cast<int>(floor_y);
  const auto texel = [&](int i, int j) {
    const bool inside = i >= 0 && j >= 0 && i < size.x && j < size.y;
    return inside ? pixel_at(i, j) : Pixel(0.0f);
  };
  const float fx = at.x - floor_x, fy = at.y - floor_y;
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), fx),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
}

}  // namespace

core::Image<glm::vec2> make_warp_map(const core::CameraModel& camera,
                                     const core::CameraModel& ideal) {
  core::Image<glm::vec2> map(camera.width, camera.height,
                             glm::vec2(std::numeric_limits<float>::quiet_NaN()));
  tbb::parallel_for(0, camera.height, [&](int y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto direction = core::pixel_direction(camera, {x, y});
      const auto at = direction ? core::project(ideal, *direction) : std::nullopt;
      if (at) map.at(x, y) = glm::vec2(*at);
    }
  });
  return map;
}

Layers warp_layers(const Layers& ideal_layers, const core::Image<glm::vec2>& map) {
  Layers warped(map.size());
  const auto over_at = [&](int x, int y) { return ideal_layers.over(x, y); };
  const auto difference_at = [&](int x, int y) { return ideal_layers.difference(x, y); };
  tbb::parallel_for(std::size_t{0}, warped.grid().count(), [&](std::size_t tile) {
    const glm::ivec2 first = warped.grid().first_pixel(tile), end = warped.grid().end_pixel(tile);
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        const glm::vec2 at = map.at(x, y);
        if (!(std::abs(at.x) < 1e6f) || !(std::abs(at.y) < 1e6f)) continue;
        const auto over = bilinear<glm::vec4>(ideal_layers.size(), over_at, at);
        const auto difference = bilinear<glm::vec3>(ideal_layers.size(), difference_at, at);
        if (over == glm::vec4(0.0f) && difference == glm::vec3(0.0f)) continue;
        warped.set(x, y, over, difference);
      }
    }
  });
  return warped;
}

graph::Handle<Layers> add_warp_pass(graph::FrameGraph& graph, graph::Handle<Layers> ideal_layers,
                                    const core::Image<glm::vec2>& map) {
  graph::Builder builder = graph.add_pass("warp");
  builder.needs(ideal_layers);
  const auto out = builder.writes<Layers>("warped layers");
  builder.runs([ideal_layers, out, &map](const graph::Access& access) {
    access.set(out, warp_layers(access.get(ideal_layers), map));
  });
  return out;
}

}  // namespace amalgam::passes
