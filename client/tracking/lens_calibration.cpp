#include "client/tracking/lens_calibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/persistence.hpp>
#include <stdexcept>

#include "common/whole_file.h"

namespace amalgam::client {
namespace {

constexpr double kFlat = 1e-4;  // of the board's size

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

bool is_flat(const tracking::MarkerBoard& board) {
  double extent = 0.0, height = 0.0;
  for (const tracking::BoardMarker& marker : board.markers) {
    for (const glm::dvec3& corner : marker.corners) {
      extent = std::max({extent, std::abs(corner.x), std::abs(corner.y)});
      height = std::max(height, std::abs(corner.z));
    }
  }
  return height <= kFlat * extent;
}

cv::Vec3d normal_of(const cv::Mat& rotation_vector) {
  cv::Matx33d rotation;
  cv::Rodrigues(rotation_vector, rotation);
  return {rotation(0, 2), rotation(1, 2), rotation(2, 2)};
}

// Degrees between the two views that differ most.
double widest_tilt(const std::vector<cv::Mat>& rotations) {
  double least = 1.0;
  for (const cv::Mat& a : rotations) {
    for (const cv::Mat& b : rotations) least = std::min(least, normal_of(a).dot(normal_of(b)));
  }
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

}  // namespace

LensCalibration::LensCalibration(tracking::MarkerBoard board, cv::Size size)
    : board_(std::move(board)), size_(size) {
  if (!is_flat(board_)) throw std::runtime_error("a lens is calibrated with a flat board");
  if (!board_.older_markers.empty()) {
    throw std::runtime_error(
        "a ChArUco board with an even number of rows has two layouts; take one with an odd number");
  }
}

LensCalibration::View LensCalibration::view_of(
    std::span<const tracking::DetectedMarker> detected) const {
  View view;
  for (const tracking::DetectedMarker& marker : detected) {
    const tracking::BoardMarker* known = board_.find(marker.id);
    if (!known) continue;
    for (std::size_t i = 0; i < marker.corners.size(); ++i) {
      const glm::dvec3& corner = known->corners[i];
      view.board.emplace_back(static_cast<float>(corner.x), static_cast<float>(corner.y), 0.0f);
      view.pixels.emplace_back(static_cast<float>(marker.corners[i].x),
                               static_cast<float>(marker.corners[i].y));
    }
  }
  return view;
}

// By the corners that both have.
bool LensCalibration::is_like(const View& a, const View& b) const {
  double distance = 0.0;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < a.board.size(); ++i) {
    const auto same = std::ranges::find(b.board, a.board[i]);
    if (same == b.board.end()) continue;
    const auto index = static_cast<std::size_t>(same - b.board.begin());
    distance += cv::norm(a.pixels[i] - b.pixels[index]);
    ++shared;
  }
  return shared > 0 && distance < kMoved * size_.width * static_cast<double>(shared);
}

LensCalibration::Offer LensCalibration::offer(std::span<const tracking::DetectedMarker> detected) {
  if (views_.size() >= kMostViews) return Offer::Full;
  View view = view_of(detected);
  if (view.board.size() < 4 * std::min(kFewestMarkers, board_.markers.size())) {
    return Offer::TooFewMarkers;
  }
  for (const View& other : views_) {
    if (is_like(view, other)) return Offer::LikeAnother;
  }
  for (const cv::Point2f& pixel : view.pixels) {
    const int x =
        std::clamp(static_cast<int>(double{pixel.x} * kCells / size_.width), 0, kCells - 1);
    const int y =
        std::clamp(static_cast<int>(double{pixel.y} * kCells / size_.height), 0, kCells - 1);
    seen_[static_cast<std::size_t>(y * kCells + x)] = true;
  }
  views_.push_back(std::move(view));
  return Offer::Taken;
}

double LensCalibration::coverage() const {
  return static_cast<double>(std::ranges::count(seen_, true)) / static_cast<double>(seen_.size());
}

bool LensCalibration::is_enough() const {
  return views_.size() >= kMostViews ||
         (views_.size() >= kGoodViews && coverage() >= kGoodCoverage);
}

LensCalibration::Result LensCalibration::solve() const {
  if (views_.size() < kFewestViews) {
    throw std::runtime_error(std::to_string(views_.size()) + " different views of the board; " +
                             std::to_string(kFewestViews) + " are needed");
  }
  if (coverage() < kLeastCoverage) {
    throw std::runtime_error("the board was seen in " + rounded(100.0 * coverage()) +
                             " % of the picture; " + rounded(100.0 * kLeastCoverage) +
                             " % are needed: hold it into the corners too");
  }
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const View& view : views_) {
    board.push_back(view.board);
    pixels.push_back(view.pixels);
  }
  cv::Matx33d matrix = cv::Matx33d::eye();
  cv::Mat distortion;
  std::vector<cv::Mat> rotations, translations;
  Result result;
  // The third radial coefficient is ill determined by a few dozen views.
  result.error = cv::calibrateCamera(board, pixels, size_, matrix, distortion, rotations,
                                     translations, cv::CALIB_FIX_K3);
  result.tilt = widest_tilt(rotations);
  if (result.tilt < kLeastTilt) {
    throw std::runtime_error("all views are alike: the board was turned by " +
                             rounded(result.tilt) + " degrees; " + rounded(kLeastTilt) +
                             " are needed");
  }
  if (!(result.error <= kWorstError * size_.width / kUsualWidth)) {
    throw std::runtime_error("the views contradict each other by " + rounded(result.error) +
                             " pixels: the board is bent, the pictures are blurred, or the "
                             "camera focused anew in between");
  }
  common::CameraModel& camera = result.camera;
  camera.width = size_.width;
  camera.height = size_.height;
  camera.fx = matrix(0, 0);
  camera.fy = matrix(1, 1);
  camera.cx = matrix(0, 2);
  camera.cy = matrix(1, 2);
  for (int i = 0; i < 4; ++i)
    camera.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("the views give no lens that can be used: " + defect);
  }
  return result;
}

void write_calibration(const std::filesystem::path& file, const LensCalibration::Result& result) {
  const common::CameraModel& camera = result.camera;
  cv::FileStorage storage(
      ".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
  storage << "image_width" << camera.width << "image_height" << camera.height;
  storage << "camera_matrix"
          << cv::Mat(cv::Matx33d(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1));
  const auto& k = camera.distortion;
  storage << "distortion_coefficients"
          << cv::Mat(cv::Matx<double, 5, 1>(k[0], k[1], k[2], k[3], 0));
  storage << "avg_reprojection_error" << result.error;
  common::write_whole_file(file, storage.releaseAndGetString());
}

}  // namespace amalgam::client
