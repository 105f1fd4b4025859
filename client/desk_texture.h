// A square of the desk as pixels, in several sizes, so that a sample costs the same near and far.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/image.h"

namespace amalgam::client {

class DeskTexture {
 public:
  // Calls colour_at (8-bit sRGB values, 0..255) once for each texel's centre. Lengths in metres on
  // the desk; the square starts at low and extends by side in +x and +y.
  DeskTexture(const glm::dvec2& low, double side, int texels,
              const std::function<glm::vec3(const glm::dvec2&)>& colour_at);

  bool covers(const glm::dvec2& point) const;

  // Bilinear, from the level whose texels are nearest below the footprint (metres on the desk that
  // the sample stands for). The point must be covered.
  glm::vec3 sample(const glm::dvec2& point, double footprint) const;

 private:
  glm::dvec2 low_;
  double side_;
  double texel_;                         // metres, of level 0
  std::vector<core::ImageRgb8> levels_;  // each half as wide as the one before
};

}  // namespace amalgam::client
