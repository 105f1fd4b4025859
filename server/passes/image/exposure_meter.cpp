#include "passes/image/exposure_meter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/light/tone_map.h"

namespace amalgam::passes {
namespace {

float luminance(const glm::vec3& rgb) {
  return glm::dot(rgb, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

// The camera image's pixel at a grid entry, if it is inside.
std::optional<glm::ivec2> camera_pixel(const MeterGrid& grid, int x, int y,
                                       const common::CameraModel& ideal,
                                       const common::CameraModel& camera) {
  const int n = grid.samples_per_side;
  const auto sample = [&](int i, int side) {
    return (std::min(i * grid.step + grid.step / 2, side * n - 1) + 0.5) / n - 0.5;
  };
  const auto direction =
      common::pixel_direction(ideal, {sample(x, ideal.width), sample(y, ideal.height)});
  const auto at = direction ? common::project(camera, *direction) : std::nullopt;
  if (!at) return std::nullopt;
  const glm::ivec2 pixel(std::lround(at->x), std::lround(at->y));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= camera.width || pixel.y >= camera.height)
    return std::nullopt;
  return pixel;
}

}  // namespace

int meter_step(glm::ivec2 sample_size) {
  constexpr double kEntries = 5000.0;
  const double area = static_cast<double>(sample_size.x) * sample_size.y;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(area / kEntries))));
}

std::optional<float> meter_exposure(const MeterGrid& grid, const common::CameraModel& ideal,
                                    const common::CameraModel& camera,
                                    const common::ImageRgb8& image) {
  // Outside these bytes the camera clips or is mostly noise.
  constexpr float kDarkest = 8.0f / 255.0f, kBrightest = 250.0f / 255.0f;
  const float dark = scene::srgb_decode(kDarkest), bright = scene::srgb_decode(kBrightest);
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
      ratios.push_back(luminance(scene::inverse_tone_map(display, 1.0f)) / modelled);
    }
  }
  if (ratios.empty()) return std::nullopt;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return std::clamp(*middle, 1e-6f, 1e6f);
}

}  // namespace amalgam::passes
