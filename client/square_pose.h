// The two poses that a flat square marker may have when all that is known are its four corners.
//
// Seen with little perspective, a tilted square and its mirror image about the line of sight look
// the same, so IPPE [Collins & Bartoli 2014] gives both; which one is real is for PoseMemory to
// say.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/camera_model.h"
#include "core/pose.h"

namespace amalgam::client {

// Pixels of the (distorted) camera image: top left, top right, bottom right, bottom left of the
// printed marker, as OpenCV's detector orders them.
using SquareCorners = std::array<glm::dvec2, 4>;

struct SquareSolution {
  core::MarkerPose pose;  // camera_from_marker; its marker id is left 0
  double error = 0.0;     // root mean square distance of the corners, pixels without distortion
};

// None, one or two solutions, the better one first. Left out: solutions that are not finite, lie
// behind the camera or show the marker's back, or whose rotation is off orthonormal by more than
// 1e-3 (numerics B22). None at all if a corner lies where the lens model cannot be inverted.
// marker_length in metres.
std::vector<SquareSolution> solve_square(const SquareCorners& corners, double marker_length,
                                         const core::CameraModel& camera);

// The angle between two rotations, radians, 0 to pi.
double angle_between(const glm::dquat& a, const glm::dquat& b);

}  // namespace amalgam::client
