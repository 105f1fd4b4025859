// The equidistant fish-eye lens, which may see more than a half-space: maps directions to pixels
// and back.
//
// Fish-eye frame: x right, y down, z forward along the lens's axis. A direction at the angle t from
// the axis is seen at the distance r = f t (radians) from the principal point [Miyamoto 1964].
// Pixel coordinates: (0, 0) is the *centre* of the top left pixel.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace amalgam::common {

struct FisheyeModel {
  int width = 0;              // pixels
  int height = 0;             // pixels
  double fx = 0.0, fy = 0.0;  // pixels for each radian
  double cx = 0.0, cy = 0.0;  // principal point, pixels
  double max_angle = 0.0;     // radians from the axis; the image shows nothing beyond

  bool operator==(const FisheyeModel&) const = default;
};

// An empty string if the model can be used, otherwise its defect: sides not in 1..8192, focal
// lengths not finite or not in [1, 1e6], a principal point further than ten image sides away, or a
// max_angle not in (0, pi].
std::string describe_defect(const FisheyeModel& fisheye);

// The pixel that sees a direction (of any length) of the fish-eye frame; it may lie outside the
// image. Nothing beyond max_angle, or for a direction that is 0 or not finite. The direction
// straight behind (max_angle = pi) is a whole circle in the image; returns one point of it.
std::optional<glm::dvec2> project(const FisheyeModel& fisheye, const glm::dvec3& direction);

// The unit direction that a pixel sees; nothing beyond max_angle.
std::optional<glm::dvec3> pixel_direction(const FisheyeModel& fisheye, const glm::dvec2& pixel);

}  // namespace amalgam::common
