// One pose that explains where a target's points are seen; flat targets usually have two.
//
// Seen with little perspective, a tilted plane and its mirror image about the line of sight look
// the same, so IPPE [Collins & Bartoli 2014] gives both; which one is real is for
// PoseDisambiguation to say.
#pragma once

#include <glm/vec2.hpp>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"

namespace amalgam::client {

struct PoseSolution {
  common::MarkerPose pose;  // camera_from_target; its marker id is left 0
  double error = 0.0;       // root mean square distance of the points, pixels without distortion
};

// From a rotation vector and a translation as OpenCV gives them. Nothing if they are not finite,
// lie behind the camera, or if the rotation is off orthonormal by more than 1e-3 (numerics B22).
std::optional<PoseSolution> make_solution(const cv::Mat& rotation_vector,
                                          const cv::Mat& translation, double error);

// Where an ideal lens would have put these pixels. Nothing if one lies where the lens model cannot
// be inverted. Not left to OpenCV's solvers, whose inversion of the distortion stops after five
// steps whatever the remaining error.
std::optional<std::vector<cv::Point2d>> ideal_pixels(std::span<const glm::dvec2> pixels,
                                                     const common::CameraModel& camera);

cv::Matx33d intrinsic_matrix(const common::CameraModel& camera);

// The angle between two rotations, radians, 0 to pi.
double angle_between(const glm::dquat& a, const glm::dquat& b);

}  // namespace amalgam::client
