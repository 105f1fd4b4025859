// A square of the desk as pixels, with mip levels, so that a sample costs the same near and far.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "client/synthetic/packed_color.h"
#include "common/image.h"

namespace amalgam::client {

class DeskTexture {
 public:
  // Calls color_at (8-bit sRGB values, 0..255) once for each texel's centre. Lengths in metres on
  // the desk; the square starts at low and extends by side in +x and +y.
  DeskTexture(const glm::dvec2& low, double side, int texels,
              const std::function<glm::vec3(const glm::dvec2&)>& color_at);

  bool covers(const glm::dvec2& point) const {
    return point.x >= low_.x && point.y >= low_.y && point.x < low_.x + side_ &&
           point.y < low_.y + side_;
  }

  // Bilinear, from the coarsest level whose texels are not larger than the footprint (the sample's
  // width on the desk, metres). The point must be covered.
  PackedColor sample(const glm::dvec2& point, double footprint) const;

 private:
  struct Level {
    common::Image<PackedColor> texels;
    double scale = 0.0;  // 1/256 texels in a metre
  };

  glm::dvec2 low_;
  double side_;
  double texel_;               // metres, of level 0
  std::vector<Level> levels_;  // each half as wide as the one before
};

}  // namespace amalgam::client
