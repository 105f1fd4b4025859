#include "report/float_composite.h"

#include <cmath>

#include "passes/image/warp.h"
#include "scene/light/real_surfaces.h"

namespace amalgam::report {
namespace {

float shown(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : value;
}

glm::vec3 shown(const glm::vec3& light) {
  return {shown(light.r), shown(light.g), shown(light.b)};
}

glm::vec3 composed(const core::LayerPixel& pixel, const common::Rgb8& camera) {
  const glm::vec3 lit = scene::scale_light(scene::srgb_decode(camera), pixel.light_ratio(),
                                           scene::ToneCurve::Reinhard);
  return shown(glm::vec3(pixel.over) + (1.0f - pixel.over.w) * lit + pixel.difference);
}

}  // namespace

common::ImageRgb32f float_composite(const core::Layers& layers,
                                    const common::ImageRgb8& camera_image) {
  common::ImageRgb32f result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      result.at(x, y) = composed(layers.at(x, y), camera_image.at(x, y));
    }
  }
  return result;
}

common::ImageRgb32f float_composite(const reference::Layers& layers,
                                    const common::ImageRgb8& camera_image) {
  common::ImageRgb32f result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      result.at(x, y) =
          shown(glm::vec3(reference::composite_color(layers, camera_image, x, y, {})));
    }
  }
  return result;
}

core::Layers frame_layers(const frame::FrameBuffers& buffers, glm::ivec2 camera_size,
                          float render_scale) {
  const auto over = buffers.find("over"), difference = buffers.find("difference"),
             ratio = buffers.find("light_ratio");
  if (over == buffers.end()) return core::Layers(camera_size);
  const auto& a = std::get<common::ImageRgba32f>(over->second);
  const auto& d = std::get<common::ImageRgb32f>(difference->second);
  const auto& q = std::get<common::ImageRgb32f>(ratio->second);
  core::Layers layers(a.size());
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const float uncovered = 1.0f - a.at(x, y).w;
      const core::LayerPixel pixel{a.at(x, y), d.at(x, y), uncovered * (q.at(x, y) - 1.0f)};
      if (!pixel.is_zero()) layers.set(x, y, pixel);
    }
  }
  if (render_scale == 1.0f) return layers;
  return passes::warp_layers(layers, {.size = camera_size, .lens = nullptr, .scale = render_scale});
}

}  // namespace amalgam::report
