#include "client/square_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <opencv2/calib3d.hpp>
#include <optional>

namespace amalgam::client {
namespace {

constexpr double kMaxOffOrthonormal = 1e-3;

bool is_rotation(const glm::dmat3& matrix) {
  const glm::dmat3 defect = glm::transpose(matrix) * matrix - glm::dmat3(1.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      // Written so that a NaN fails.
      if (!(std::abs(defect[column][row]) <= kMaxOffOrthonormal)) return false;
    }
  }
  return glm::determinant(matrix) > 0;
}

std::optional<SquareSolution> to_solution(const cv::Mat& rotation_vector,
                                          const cv::Mat& translation, double error) {
  cv::Matx33d rotation;
  cv::Rodrigues(rotation_vector, rotation);
  glm::dmat3 matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix[column][row] = rotation(row, column);
  }
  SquareSolution solution;
  solution.pose.translation = {translation.at<double>(0), translation.at<double>(1),
                               translation.at<double>(2)};
  solution.error = error;
  if (!is_rotation(matrix) || !(solution.pose.translation.z > 0) || !std::isfinite(error)) {
    return std::nullopt;
  }
  solution.pose.rotation = glm::normalize(glm::quat_cast(matrix));
  if (!core::is_usable(solution.pose)) return std::nullopt;
  // Paper is printed on one side.
  if (!(glm::dot(matrix[2], solution.pose.translation) < 0)) return std::nullopt;
  return solution;
}

// Where an ideal lens would have put the corners. Not left to solvePnP, whose inversion of the
// distortion stops after five steps whatever the remaining error.
std::optional<std::vector<cv::Point2d>> ideal_corners(const SquareCorners& corners,
                                                      const core::CameraModel& camera) {
  std::vector<cv::Point2d> ideal;
  for (const glm::dvec2& corner : corners) {
    const auto direction = core::pixel_direction(camera, corner);
    if (!direction) return std::nullopt;
    ideal.emplace_back(camera.fx * direction->x + camera.cx, camera.fy * direction->y + camera.cy);
  }
  return ideal;
}

std::vector<SquareSolution> solve_ideal(const std::vector<cv::Point2d>& corners, double length,
                                        const core::CameraModel& camera) {
  const double half = 0.5 * length;
  const std::vector<cv::Point3d> marker{
      {-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}};
  const cv::Matx33d intrinsics(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  std::vector<cv::Mat> rotations, translations;
  cv::Mat errors;
  std::vector<SquareSolution> solutions;
  try {
    cv::solvePnPGeneric(marker, corners, intrinsics, cv::noArray(), rotations, translations, false,
                        cv::SOLVEPNP_IPPE_SQUARE, cv::noArray(), cv::noArray(), errors);
  } catch (const cv::Exception&) {
    return solutions;  // corners that are no quadrilateral
  }
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const double error = errors.at<double>(static_cast<int>(i));
    if (const auto solution = to_solution(rotations[i], translations[i], error)) {
      solutions.push_back(*solution);
    }
  }
  std::ranges::stable_sort(solutions, {}, &SquareSolution::error);
  return solutions;
}

}  // namespace

std::vector<SquareSolution> solve_square(const SquareCorners& corners, double marker_length,
                                         const core::CameraModel& camera) {
  auto ideal = ideal_corners(corners, camera);
  if (!ideal) return {};
  auto solutions = solve_ideal(*ideal, marker_length, camera);
  if (solutions.empty()) {
    // A marker facing the camera exactly is a turn by pi, where OpenCV's conversion to a rotation
    // vector divides by 0 and gives none or the marker's back. A nudge far below what a corner is
    // known to gets it out of there.
    constexpr double kNudge = 1e-3;  // pixels
    ideal->front().x += kNudge;
    solutions = solve_ideal(*ideal, marker_length, camera);
  }
  return solutions;
}

double angle_between(const glm::dquat& a, const glm::dquat& b) {
  // By the half angle's sine and cosine, which stays exact for small angles where acos does not.
  const glm::dquat difference = glm::conjugate(a) * b;
  const double sine = std::hypot(difference.x, difference.y, difference.z);
  return 2.0 * std::atan2(sine, std::abs(difference.w));
}

}  // namespace amalgam::client
