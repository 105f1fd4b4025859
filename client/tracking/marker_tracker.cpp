#include "client/tracking/marker_tracker.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "client/tracking/edge_refinement.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::client {
namespace {

cv::Mat to_grey(const cv::Mat& image, cv::ColorConversionCodes from_color) {
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throw std::invalid_argument("markers are sought in 8-bit images of 1 or 3 channels");
  }
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, from_color);
  return grey;
}

}  // namespace

MarkerTracker::MarkerTracker(const TrackerOptions& options, const common::CameraModel& camera)
    : size_(camera.width, camera.height),
      refine_corners_(options.refine_corners),
      dictionary_(tracking::find_dictionary(options.dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()),
      poses_({.marker_length = options.marker_length,
              .ids = options.ids,
              .board = options.board,
              .world_marker = options.world_marker},
             camera) {}

std::vector<tracking::DetectedMarker> MarkerTracker::detect(const cv::Mat& image) const {
  return detect_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<common::MarkerPose> MarkerTracker::track(const cv::Mat& image) {
  return track_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<common::MarkerPose> MarkerTracker::track(const common::ImageRgb8& image) {
  // cv::Mat has no view of constant pixels; to_grey() only reads them.
  auto* pixels = const_cast<common::Rgb8*>(image.data());
  const cv::Mat view(image.height(), image.width(), CV_8UC3, pixels);
  return track_grey(to_grey(view, cv::COLOR_RGB2GRAY));
}

std::vector<tracking::DetectedMarker> MarkerTracker::detect_grey(const cv::Mat& grey) const {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary_, corners, ids, parameters_);
  std::vector<tracking::DetectedMarker> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!poses_.wants(ids[i])) continue;
    tracking::DetectedMarker marker{.id = ids[i], .corners = {}};
    for (std::size_t c = 0; c < 4; ++c) marker.corners[c] = {corners[i][c].x, corners[i][c].y};
    if (refine_corners_) {
      marker.corners = refine_corners(grey, dictionary_->markerSize, marker.corners);
    }
    found.push_back(marker);
  }
  return found;
}

std::vector<common::MarkerPose> MarkerTracker::track_grey(const cv::Mat& grey) {
  if (grey.size() != size_) {
    throw std::invalid_argument("the image has another size than the camera");
  }
  return poses_.track(detect_grey(grey));
}

}  // namespace amalgam::client
