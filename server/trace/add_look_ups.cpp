#include "trace/add_look_ups.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace amalgam::trace {

// Interpolates in display-linear light, so that a magnifying mirror shows what magnifying the image
// itself would show.
glm::vec3 camera_radiance(const common::ImageRgb8& image, const glm::vec2& pixel,
                          const scene::ToneMap& tone_map) {
  const int x0 = std::clamp(static_cast<int>(std::floor(pixel.x)), 0, image.width() - 1);
  const int y0 = std::clamp(static_cast<int>(std::floor(pixel.y)), 0, image.height() - 1);
  const int x1 = std::min(x0 + 1, image.width() - 1), y1 = std::min(y0 + 1, image.height() - 1);
  const float fx = pixel.x - static_cast<float>(x0), fy = pixel.y - static_cast<float>(y0);
  const auto texel = [&](int x, int y) { return scene::srgb_decode(image.at(x, y)); };
  const glm::vec3 color = glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx),
                                   glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
  return scene::inverse_tone_map(color, tone_map);
}

// Differential rendering along the ray: the camera's own color, as virtual objects change it.
void add_look_ups(TilePaths& paths, const common::ImageRgb8& image, const scene::ToneMap& tone_map,
                  scene::RealSurfaces real_surfaces) {
  for (const LookUp& look_up : paths.look_ups) {
    const glm::vec3 seen = camera_radiance(image, look_up.pixel, tone_map);
    const glm::vec3& mixed = look_up.modelled_mixed;
    const glm::vec3& real = look_up.modelled_real;
    const glm::vec3 changed = scene::change_radiance(seen, mixed, real, tone_map, real_surfaces);
    SampleResult& sample = paths.samples[look_up.sample];
    sample.mixed += look_up.weight * glm::mix(mixed, changed, look_up.trust);
    sample.real += look_up.weight * glm::mix(real, seen, look_up.trust);
  }
}

}  // namespace amalgam::trace
