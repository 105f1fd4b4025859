// The two poses that a flat square marker may have when all that is known are its four corners.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "client/pose_solution.h"
#include "common/camera_model.h"

namespace amalgam::client {

// Pixels of the (distorted) camera image: top left, top right, bottom right, bottom left of the
// printed marker, as OpenCV's detector orders them.
using SquareCorners = std::array<glm::dvec2, 4>;

// None, one or two solutions, the better one first. Left out: what make_solution() leaves out, and
// solutions that show the marker's back. None at all if a corner lies where the lens model cannot
// be inverted. marker_length in metres.
std::vector<PoseSolution> solve_square(const SquareCorners& corners, double marker_length,
                                       const common::CameraModel& camera);

}  // namespace amalgam::client
