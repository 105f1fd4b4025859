// One pose that fits the seen points of a target; flat targets usually have two.
//
// With little perspective, a tilted plane and its mirror image about the line of sight look the
// same. So IPPE [Collins & Bartoli 2014] gives both, and PoseDisambiguation chooses.
#pragma once

#include <glm/vec2.hpp>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"

namespace amalgam::tracking {

struct PoseSolution {
  common::MarkerPose pose;  // camera_from_target; its marker id is left 0
  // Root mean square, pixels. Of a square (IPPE): of the coordinates' errors, without distortion.
  // Of a board: of the corners' distances, in the distorted image, larger by sqrt(2) for equal
  // errors.
  double error = 0.0;
};

// From OpenCV's rotation vector and translation. Nothing if they are not finite, the target is
// behind the camera, or the rotation is off orthonormal by more than 1e-3 (numerics B22).
std::optional<PoseSolution> make_solution(const cv::Mat& rotation_vector,
                                          const cv::Mat& translation, double error);

// Undistorted pixels. Nothing if the lens model cannot be inverted at one of them. OpenCV's solvers
// invert the distortion too, but stop after five steps whatever the remaining error.
std::optional<std::vector<cv::Point2d>> ideal_pixels(std::span<const glm::dvec2> pixels,
                                                     const common::CameraModel& camera);

cv::Matx33d intrinsic_matrix(const common::CameraModel& camera);

// The angle between two rotations, radians, 0 to pi.
double angle_between(const glm::dquat& a, const glm::dquat& b);

}  // namespace amalgam::tracking
