#include "codec/color_space.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace amalgam::codec {
namespace {

bool is_finite(const glm::dmat3& m) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!std::isfinite(m[i][j])) return false;
    }
  }
  return true;
}

glm::dvec3 with_z(const glm::dvec2& xy) {
  return {xy.x, xy.y, 1.0 - xy.x - xy.y};
}

}  // namespace

std::optional<glm::dmat3> xyz_from_rgb(const Chromaticities& space) {
  const glm::dmat3 primaries(with_z(space.red), with_z(space.green), with_z(space.blue));
  constexpr double kLeastVolume = 1e-6;  // those of Rec. 709 have 0.11
  if (!(std::abs(glm::determinant(primaries)) >= kLeastVolume)) return std::nullopt;
  if (!(space.white.y > 0.0)) return std::nullopt;
  const glm::dvec3 shares = glm::inverse(primaries) * (with_z(space.white) / space.white.y);
  const glm::dmat3 matrix(primaries[0] * shares[0], primaries[1] * shares[1],
                          primaries[2] * shares[2]);
  if (!is_finite(matrix) || !is_finite(glm::inverse(matrix))) return std::nullopt;
  return matrix;
}

glm::dmat3 rec709_from_xyz() {
  return glm::inverse(*xyz_from_rgb(Chromaticities{}));
}

std::optional<glm::dmat3> rec709_from(const Chromaticities& space) {
  const auto to_xyz = xyz_from_rgb(space);
  if (!to_xyz) return std::nullopt;
  return rec709_from_xyz() * *to_xyz;
}

void transform_colors(common::ImageRgb32f& image, const glm::dmat3& matrix) {
  for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(matrix * glm::dvec3(pixel));
}

}  // namespace amalgam::codec
