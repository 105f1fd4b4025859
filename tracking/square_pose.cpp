#include "tracking/square_pose.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <utility>

#include "tracking/marker_board.h"

namespace amalgam::tracking {
namespace {

std::vector<PoseSolution> solve_ideal(const std::vector<cv::Point2d>& corners, double length,
                                      const common::CameraModel& camera) {
  const double half = 0.5 * length;
  const std::vector<cv::Point3d> marker{
      {-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}};
  std::vector<cv::Mat> rotations, translations;
  cv::Mat errors;
  std::vector<PoseSolution> solutions;
  try {
    cv::solvePnPGeneric(marker, corners, intrinsic_matrix(camera), cv::noArray(), rotations,
                        translations, false, cv::SOLVEPNP_IPPE_SQUARE, cv::noArray(), cv::noArray(),
                        errors);
  } catch (const cv::Exception&) {
    return solutions;  // corners that are no quadrilateral
  }
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    // Longer vectors come from a division by almost 0: see solve_square().
    constexpr double kRounding = 1e-6;
    if (!(cv::norm(rotations[i]) <= std::numbers::pi + kRounding)) continue;
    const double error = errors.at<double>(static_cast<int>(i));
    const auto solution = make_solution(rotations[i], translations[i], error);
    if (solution && shows_its_face(common::to_matrix(solution->pose)))
      solutions.push_back(*solution);
  }
  std::ranges::stable_sort(solutions, {}, &PoseSolution::error);
  return solutions;
}

}  // namespace

std::vector<PoseSolution> solve_square(const SquareCorners& corners, double marker_length,
                                       const common::CameraModel& camera) {
  auto ideal = ideal_pixels(corners, camera);
  if (!ideal) return {};
  auto solutions = solve_ideal(*ideal, marker_length, camera);
  if (solutions.size() < 2) {
    // A marker facing the camera exactly is a turn by pi, where OpenCV's conversion to a rotation
    // vector divides by (almost) 0: the right solution is missing, or both are. A nudge far below
    // what a corner is known to gets it out of there.
    constexpr double kNudge = 1e-3;  // pixels
    ideal->front().x += kNudge;
    auto nudged = solve_ideal(*ideal, marker_length, camera);
    if (nudged.size() > solutions.size()) solutions = std::move(nudged);
  }
  return solutions;
}

bool shows_its_face(const glm::dmat4& camera_from_marker) {
  return glm::dot(glm::dvec3(camera_from_marker[2]), glm::dvec3(camera_from_marker[3])) < 0;
}

std::optional<SquareCorners> project_square(const common::MarkerPose& camera_from_marker,
                                            double marker_length,
                                            const common::CameraModel& camera) {
  const BoardMarker square = square_marker(0, marker_length, glm::dmat4(1.0));
  SquareCorners pixels{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto pixel = common::project(
        camera, camera_from_marker.rotation * square.corners[i] + camera_from_marker.translation);
    if (!pixel) return std::nullopt;
    pixels[i] = *pixel;
  }
  return pixels;
}

}  // namespace amalgam::tracking
