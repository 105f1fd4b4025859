#include "report/float_composite.h"

#include <cmath>

#include "passes/image/warp.h"
#include "scene/light/tone_map.h"

namespace amalgam::report {
namespace {

float shown(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : value;
}

glm::vec3 composed(const glm::vec4& over, const glm::vec3& difference, const common::Rgb8& camera) {
  const glm::vec3 light =
      glm::vec3(over) + (1.0f - over.w) * scene::srgb_decode(camera) + difference;
  return {shown(light.r), shown(light.g), shown(light.b)};
}

}  // namespace

common::ImageRgb32f float_composite(const core::Layers& layers,
                                    const common::ImageRgb8& camera_image) {
  common::ImageRgb32f result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      result.at(x, y) = composed(layers.over(x, y), layers.difference(x, y), camera_image.at(x, y));
    }
  }
  return result;
}

common::ImageRgb32f float_composite(const reference::Layers& layers,
                                    const common::ImageRgb8& camera_image) {
  common::ImageRgb32f result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      result.at(x, y) = composed(glm::vec4(layers.over.at(x, y)),
                                 glm::vec3(layers.difference.at(x, y)), camera_image.at(x, y));
    }
  }
  return result;
}

core::Layers frame_layers(const frame::FrameBuffers& buffers, glm::ivec2 camera_size,
                          float render_scale) {
  const auto over = buffers.find("over"), difference = buffers.find("difference");
  if (over == buffers.end() || difference == buffers.end()) return core::Layers(camera_size);
  const auto& a = std::get<common::ImageRgba32f>(over->second);
  const auto& d = std::get<common::ImageRgb32f>(difference->second);
  core::Layers layers(a.size());
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (a.at(x, y) != glm::vec4(0.0f) || d.at(x, y) != glm::vec3(0.0f)) {
        layers.set(x, y, a.at(x, y), d.at(x, y));
      }
    }
  }
  if (render_scale == 1.0f) return layers;
  return passes::warp_layers(layers, {.size = camera_size, .lens = nullptr, .scale = render_scale});
}

}  // namespace amalgam::report
