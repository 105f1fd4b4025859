// The picture on the synthetic desk, without the marker: the color of a point by formula.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace amalgam::client {

// The white sheet around the marker: half its width, and where it ends below and above, metres.
inline constexpr double kSheetHalfWidth = 0.0525;
inline constexpr double kSheetBottom = -0.085;
inline constexpr double kSheetTop = 0.063;

// A point of the desk as in synthetic_desk.h; 8-bit sRGB values, 0..255.
glm::vec3 desk_picture(const glm::dvec2& point);

}  // namespace amalgam::client
