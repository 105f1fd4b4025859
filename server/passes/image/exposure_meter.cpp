#include "passes/image/exposure_meter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/light/tone_map.h"

namespace amalgam::passes {
namespace {

// The camera image's pixel at a grid entry, if it is inside.
std::optional<glm::ivec2> camera_pixel(const MeterGrid& grid, int x, int y,
                                       const common::CameraModel& ideal,
                                       const common::CameraModel& camera) {
  const auto direction = common::pixel_direction(ideal, grid.ideal_pixel(x, y, ideal));
  const auto at = direction ? common::project(camera, *direction) : std::nullopt;
  if (!at) return std::nullopt;
  const glm::ivec2 pixel(std::lround(at->x), std::lround(at->y));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= camera.width || pixel.y >= camera.height)
    return std::nullopt;
  return pixel;
}

}  // namespace

float darkest_metered() {
  return scene::srgb_decode(8.0f / 255.0f);
}

float brightest_metered() {
  return scene::srgb_decode(250.0f / 255.0f);
}

std::optional<float> meter_exposure(const MeterGrid& grid, const common::CameraModel& ideal,
                                    const common::CameraModel& camera,
                                    const common::ImageRgb8& image, scene::ToneCurve curve) {
  const float dark = darkest_metered(), bright = brightest_metered();
  const scene::ToneMap response = scene::tone_map_of(1.0f, curve);
  std::vector<float> ratios;
  for (int y = 0; y < grid.real.height(); ++y) {
    for (int x = 0; x < grid.real.width(); ++x) {
      const glm::vec4& real = grid.real.at(x, y);
      const float modelled = luminance(glm::vec3(real));
      if (real.w < 0.5f || !std::isfinite(modelled) || !(modelled > 0.0f)) continue;
      const auto pixel = camera_pixel(grid, x, y, ideal, camera);
      if (!pixel) continue;
      const glm::vec3 display = scene::srgb_decode(image.at(pixel->x, pixel->y));
      const float brightness = luminance(display);
      if (brightness < dark || brightness > bright) continue;
      ratios.push_back(luminance(scene::inverse_tone_map(display, response)) / modelled);
    }
  }
  if (ratios.empty()) return std::nullopt;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return std::clamp(*middle, 1e-6f, 1e6f);
}

}  // namespace amalgam::passes
