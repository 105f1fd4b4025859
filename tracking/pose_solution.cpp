#include "tracking/pose_solution.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <opencv2/calib3d.hpp>

namespace amalgam::tracking {
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

}  // namespace

std::optional<PoseSolution> make_solution(const cv::Mat& rotation_vector,
                                          const cv::Mat& translation, double error) {
  cv::Matx33d rotation;
  cv::Rodrigues(rotation_vector, rotation);
  glm::dmat3 matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix[column][row] = rotation(row, column);
  }
  PoseSolution solution;
  solution.pose.translation = {translation.at<double>(0), translation.at<double>(1),
                               translation.at<double>(2)};
  solution.error = error;
  if (!is_rotation(matrix) || !(solution.pose.translation.z > 0) || !std::isfinite(error)) {
    return std::nullopt;
  }
  solution.pose.rotation = glm::normalize(glm::quat_cast(matrix));
  if (!common::is_usable(solution.pose)) return std::nullopt;
  return solution;
}

std::optional<std::vector<cv::Point2d>> ideal_pixels(std::span<const glm::dvec2> pixels,
                                                     const common::CameraModel& camera) {
  std::vector<cv::Point2d> ideal;
  for (const glm::dvec2& pixel : pixels) {
    const auto direction = common::pixel_direction(camera, pixel);
    if (!direction) return std::nullopt;
    ideal.emplace_back(camera.fx * direction->x + camera.cx, camera.fy * direction->y + camera.cy);
  }
  return ideal;
}

cv::Matx33d intrinsic_matrix(const common::CameraModel& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

double angle_between(const glm::dquat& a, const glm::dquat& b) {
  // By the half angle's sine and cosine, which stays exact for small angles where acos does not.
  const glm::dquat difference = glm::conjugate(a) * b;
  const double sine = std::hypot(difference.x, difference.y, difference.z);
  return 2.0 * std::atan2(sine, std::abs(difference.w));
}

}  // namespace amalgam::tracking
