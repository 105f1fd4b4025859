// A lens from pictures of a flat board of markers [Zhang 2000]: chooses among the pictures, says
// what is still missing, and refuses sets that do not determine the lens.
#pragma once

#include <array>
#include <filesystem>
#include <opencv2/core/types.hpp>
#include <span>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "tracking/detected_marker.h"
#include "tracking/marker_board.h"

namespace amalgam::client {

class LensCalibration {
 public:
  // The page for browsers has the same numbers (client/web/source/lens/limits.json).
  static constexpr std::size_t kFewestMarkers = 4;  // of the board, in a picture
  static constexpr double kMoved = 0.04;  // of the picture's width, on average: another view
  static constexpr std::size_t kFewestViews = 8;
  static constexpr std::size_t kGoodViews = 20;
  static constexpr std::size_t kMostViews = 40;  // enough, and solved within seconds
  static constexpr int kCells = 5;               // that the picture is divided into, on each axis
  static constexpr double kLeastCoverage = 0.6;  // share of these cells with corners
  static constexpr double kGoodCoverage = 0.9;
  static constexpr double kLeastTilt = 15.0;  // degrees between the most different views
  static constexpr double kWorstError = 1.0;  // pixels at the usual width, root mean square
  static constexpr double kUsualWidth = 640.0;

  // size: of the pictures, pixels. Throws std::runtime_error for a board that is not flat, or whose
  // layout is not known (an even number of rows of a ChArUco board: OpenCV has had two).
  LensCalibration(tracking::MarkerBoard board, cv::Size size);

  enum class Offer { Taken, TooFewMarkers, LikeAnother, Full };
  // The markers of one picture. Needs four of the board, and another view than those before.
  Offer offer(std::span<const tracking::DetectedMarker> detected);

  std::size_t views() const { return views_.size(); }
  double coverage() const;
  bool is_enough() const;  // more pictures would add little

  struct Result {
    common::CameraModel camera;
    double error = 0.0;  // of all corners, pixels, root mean square
    double tilt = 0.0;   // degrees between the most different views
  };
  // Throws std::runtime_error saying what is wrong with the set.
  Result solve() const;

 private:
  struct View {
    std::vector<cv::Point3f> board;
    std::vector<cv::Point2f> pixels;
  };
  bool is_like(const View& a, const View& b) const;
  View view_of(std::span<const tracking::DetectedMarker> detected) const;

  tracking::MarkerBoard board_;
  cv::Size size_;
  std::vector<View> views_;
  std::array<bool, kCells * kCells> seen_{};
};

// As OpenCV's YAML, which load_calibration() reads. Throws std::runtime_error.
void write_calibration(const std::filesystem::path& file, const LensCalibration::Result& result);

}  // namespace amalgam::client
