// The two possible poses of a flat square marker, from its four corners.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "tracking/pose_solution.h"

namespace amalgam::tracking {

// Pixels of the (distorted) camera image: top left, top right, bottom right, bottom left of the
// printed marker, as OpenCV's detector orders them.
using SquareCorners = std::array<glm::dvec2, 4>;

// None, one or two solutions, the better one first. Without solutions that make_solution() rejects
// or that show the marker's back. None if the lens model cannot be inverted at a corner.
// marker_length in metres.
std::vector<PoseSolution> solve_square(const SquareCorners& corners, double marker_length,
                                       const common::CameraModel& camera);

// Whether the camera sees the printed side of a marker. Paper has one.
bool shows_its_face(const glm::dmat4& camera_from_marker);

// Where the corners of a marker with this pose appear. Nothing if the camera does not see one.
std::optional<SquareCorners> project_square(const common::MarkerPose& camera_from_marker,
                                            double marker_length,
                                            const common::CameraModel& camera);

}  // namespace amalgam::tracking
