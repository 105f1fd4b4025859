// Images of several printed markers, each with a pose of its own, for tests of tracking.
#pragma once

#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "tracking/marker_board.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::client {

struct Print {
  int id = 0;
  double length = 0.05;                          // metres
  glm::dmat4 camera_from_marker = glm::dmat4();  // of a camera without distortion
  double margin = 1.0 / 6.0;                     // white around it, in its length
};

// A grey image; later prints lie over earlier ones. Lines are smooth: the image is the mean of 4 x
// 4 samples a pixel.
inline cv::Mat photograph(const common::CameraModel& camera, const std::vector<Print>& prints,
                          const std::string& dictionary = "DICT_6X6_250") {
  constexpr int kSamples = 4, kMarkerPixels = 480;
  const auto known = tracking::find_dictionary(dictionary);
  cv::Mat large(camera.height * kSamples, camera.width * kSamples, CV_8UC1, cv::Scalar(110));
  for (const Print& print : prints) {
    cv::Mat marker, sheet;
    cv::aruco::drawMarker(known, print.id, kMarkerPixels, marker);
    const int margin = static_cast<int>(std::lround(kMarkerPixels * print.margin));
    cv::copyMakeBorder(marker, sheet, margin, margin, margin, margin, cv::BORDER_CONSTANT,
                       cv::Scalar(255));
    const double half = print.length / 2 * sheet.cols / kMarkerPixels;
    const auto side = static_cast<float>(sheet.cols);
    std::vector<cv::Point2f> seen;
    for (const auto& [x, y] :
         {std::pair(-half, half), {half, half}, {half, -half}, {-half, -half}}) {
      const glm::dvec3 point(print.camera_from_marker * glm::dvec4(x, y, 0, 1));
      const glm::dvec2 pixel = (common::project(camera, point).value() + 0.5) * double{kSamples};
      seen.emplace_back(static_cast<float>(pixel.x - 0.5), static_cast<float>(pixel.y - 0.5));
    }
    const std::vector<cv::Point2f> drawn{
        {-0.5f, -0.5f}, {side - 0.5f, -0.5f}, {side - 0.5f, side - 0.5f}, {-0.5f, side - 0.5f}};
    const cv::Rect covered = cv::boundingRect(seen) & cv::Rect(0, 0, large.cols, large.rows);
    for (cv::Point2f& corner : seen) corner -= cv::Point2f(covered.tl());
    cv::Mat part = large(covered);
    cv::warpPerspective(sheet, part, cv::getPerspectiveTransform(drawn, seen), part.size(),
                        cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  }
  cv::Mat image;
  cv::resize(large, image, {camera.width, camera.height}, 0, 0, cv::INTER_AREA);
  return image;
}

// The prints of a flat board of square markers.
inline std::vector<Print> prints_of(const tracking::MarkerBoard& board,
                                    const common::MarkerPose& pose) {
  std::vector<Print> prints;
  for (const tracking::BoardMarker& marker : board.markers) {
    const glm::dvec3 side = marker.corners[1] - marker.corners[0];
    prints.push_back({marker.id, std::sqrt(side.x * side.x + side.y * side.y + side.z * side.z),
                      common::to_matrix(pose) * frame_of(marker)});
  }
  return prints;
}

}  // namespace amalgam::client
