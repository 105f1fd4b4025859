// Converts pictures from the primaries that a file states to Rec. 709, in which the renderer works.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "common/image.h"

namespace amalgam::codec {

// CIE 1931 xy of a color space's primaries and white point.
struct Chromaticities {
  glm::dvec2 red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06};  // Rec. 709
  glm::dvec2 white{0.3127, 0.3290};                                 // D65

  bool operator==(const Chromaticities&) const = default;
};

// Column vectors: XYZ = matrix * RGB, white at Y = 1. Nothing if the primaries span no color space.
std::optional<glm::dmat3> xyz_from_rgb(const Chromaticities& space);

// Colors that look the same, without adaptation to another white: the file states the light, and
// light is what an environment map is for.
std::optional<glm::dmat3> rec709_from(const Chromaticities& space);
glm::dmat3 rec709_from_xyz();

void transform_colors(common::ImageRgb32f& image, const glm::dmat3& matrix);

}  // namespace amalgam::codec
