#include "tracking/board_pose.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <opencv2/calib3d.hpp>
#include <optional>

namespace amalgam::tracking {
namespace {

constexpr double kOutlierLimit = 1.0 / 320.0;  // of the image's width
constexpr double kOutlierRatio = 3.0;          // to the others' error
constexpr double kHopelessRatio = 10.0;        // to the limit
constexpr std::size_t kCandidates = 5;         // the wrong marker is among those that fit worst

using Markers = std::vector<SeenBoardMarker>;

bool shows_faces(const Markers& markers, const common::MarkerPose& pose) {
  const glm::dmat4 camera_from_board = common::to_matrix(pose);
  return std::ranges::all_of(markers, [&](const SeenBoardMarker& seen) {
    return shows_its_face(camera_from_board * frame_of(*seen.marker));
  });
}

// Root mean square over the corners of all these markers.
double error_of(const Markers& markers, const common::MarkerPose& pose,
                const common::CameraModel& camera) {
  double sum = 0.0;
  for (const SeenBoardMarker& seen : markers) {
    const double error = reprojection_error(seen, pose, camera);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(markers.size()));
}

// Whether they lie in a plane to within a hundredth of their extent. Refining then corrects IPPE's
// error.
bool is_flat(const std::vector<cv::Point3d>& points) {
  const cv::Mat all(static_cast<int>(points.size()), 3, CV_64F,
                    const_cast<cv::Point3d*>(points.data()));
  cv::Mat mean;
  cv::reduce(all, mean, 0, cv::REDUCE_AVG);
  cv::Mat singular;
  cv::SVD::compute(all - cv::repeat(mean, all.rows, 1), singular, cv::SVD::NO_UV);
  return singular.at<double>(2) < 1e-2 * singular.at<double>(0);
}

// start: pixels for the closed form; pixels: for refining.
std::vector<PoseSolution> solve_ideal(const std::vector<cv::Point3d>& points,
                                      const std::vector<cv::Point2d>& start,
                                      const std::vector<cv::Point2d>& pixels,
                                      const Markers& markers, const common::CameraModel& camera) {
  const cv::Matx33d intrinsics = intrinsic_matrix(camera);
  const auto method = is_flat(points) ? cv::SOLVEPNP_IPPE : cv::SOLVEPNP_SQPNP;
  std::vector<cv::Mat> rotations, translations;
  std::vector<PoseSolution> solutions;
  try {
    cv::solvePnPGeneric(points, start, intrinsics, cv::noArray(), rotations, translations, false,
                        method);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      cv::solvePnPRefineLM(points, pixels, intrinsics, cv::noArray(), rotations[i],
                           translations[i]);
      auto solution = make_solution(rotations[i], translations[i], 0.0);
      if (!solution || !shows_faces(markers, solution->pose)) continue;
      solution->error = error_of(markers, solution->pose, camera);
      if (std::isfinite(solution->error)) solutions.push_back(*solution);
    }
  } catch (const cv::Exception&) {
    return {};  // points that have no pose
  }
  std::ranges::stable_sort(solutions, {}, &PoseSolution::error);
  return solutions;
}

std::vector<PoseSolution> solve(const Markers& markers, const common::CameraModel& camera) {
  std::vector<cv::Point3d> points;
  std::vector<glm::dvec2> seen;
  for (const SeenBoardMarker& marker : markers) {
    for (const glm::dvec3& p : marker.marker->corners) points.emplace_back(p.x, p.y, p.z);
    seen.insert(seen.end(), marker.corners.begin(), marker.corners.end());
  }
  const auto pixels = ideal_pixels(seen, camera);
  if (!pixels) return {};
  // A board that faces the camera exactly is a turn by pi, where OpenCV's conversion to a rotation
  // vector divides by 0. The closed form is kept away from there; refining makes good for it.
  constexpr double kNudge = 1e-2;  // pixels
  auto start = *pixels;
  start.front().x += kNudge;
  return solve_ideal(points, start, *pixels, markers, camera);
}

struct Removal {
  Markers rest;
  std::vector<PoseSolution> solutions;
  int id = 0;
};

// The markers that the pose fits worst; all if there is no pose; none if it fits them all.
std::vector<std::size_t> suspects(const Markers& markers, const std::vector<PoseSolution>& poses,
                                  double limit, const common::CameraModel& camera) {
  std::vector<std::pair<double, std::size_t>> by_error;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const double error =
        poses.empty() ? INFINITY : reprojection_error(markers[i], poses.front().pose, camera);
    by_error.emplace_back(error, i);
  }
  std::ranges::sort(by_error, std::greater());
  if (by_error.front().first <= limit) return {};
  if (!poses.empty()) by_error.resize(std::min(by_error.size(), kCandidates));
  std::vector<std::size_t> indices;
  for (const auto& [error, index] : by_error) indices.push_back(index);
  return indices;
}

// The marker without which the others agree best, if it then stands out from them.
std::optional<Removal> remove_outlier(const Markers& markers,
                                      const std::vector<PoseSolution>& poses, double limit,
                                      const common::CameraModel& camera) {
  std::optional<Removal> best;
  double removed_error = 0.0;
  for (const std::size_t index : suspects(markers, poses, limit, camera)) {
    Removal removal{markers, {}, markers[index].marker->id};
    removal.rest.erase(removal.rest.begin() + static_cast<std::ptrdiff_t>(index));
    removal.solutions = solve(removal.rest, camera);
    if (removal.solutions.empty()) continue;
    const PoseSolution& solution = removal.solutions.front();
    if (best && best->solutions.front().error <= solution.error) continue;
    removed_error = reprojection_error(markers[index], solution.pose, camera);
    best = std::move(removal);
  }
  if (!best) return std::nullopt;
  const double needed = std::max(limit, kOutlierRatio * best->solutions.front().error);
  return removed_error > needed ? best : std::nullopt;
}

}  // namespace

double reprojection_error(const SeenBoardMarker& seen, const common::MarkerPose& camera_from_board,
                          const common::CameraModel& camera) {
  const glm::dmat4 matrix = common::to_matrix(camera_from_board);
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.corners.size(); ++i) {
    const glm::dvec3 point(matrix * glm::dvec4(seen.marker->corners[i], 1.0));
    const auto pixel = common::project(camera, point);
    if (!pixel) return INFINITY;
    const glm::dvec2 off = *pixel - seen.corners[i];
    sum += glm::dot(off, off);
  }
  return std::sqrt(sum / static_cast<double>(seen.corners.size()));
}

BoardFit solve_board(std::span<const SeenBoardMarker> seen, const common::CameraModel& camera) {
  BoardFit fit;
  if (seen.empty()) return fit;
  const double limit = kOutlierLimit * camera.width;
  Markers markers(seen.begin(), seen.end());
  fit.solutions = solve(markers, camera);
  const std::size_t fewest = seen.size() / 2 + 1;  // a majority
  while (markers.size() > fewest) {
    auto removal = remove_outlier(markers, fit.solutions, limit, camera);
    if (!removal) break;
    fit.outliers.push_back(removal->id);
    markers = std::move(removal->rest);
    fit.solutions = std::move(removal->solutions);
  }
  if (!fit.solutions.empty() && fit.solutions.front().error > kHopelessRatio * limit) {
    fit.solutions.clear();
  }
  return fit;
}

}  // namespace amalgam::tracking
