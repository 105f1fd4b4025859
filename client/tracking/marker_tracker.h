// Finds ArUco markers in camera images and their poses, from frame to frame.
//
// Poses are camera_from_marker (common/pose.h). An unseen marker has no entry, unless it belongs to
// a board with seen markers; the server holds last good poses. For one thread at a time.
#pragma once

#include <opencv2/aruco.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"
#include "tracking/pose_tracker.h"

namespace amalgam::client {

// Most as tracking::PoseTrackerOptions.
struct TrackerOptions {
  std::string dictionary = "DICT_6X6_250";  // see tracking::find_dictionary()
  double marker_length = 0.05;              // metres, side of the black square
  std::vector<int> ids{};                   // markers of interest; empty: all of the dictionary
  bool refine_corners = true;               // to fractions of a pixel, as poses need
  std::optional<tracking::MarkerBoard> board{};
  int world_marker = -1;  // needed only with a board
};

class MarkerTracker {
 public:
  // Throws std::runtime_error for an unknown dictionary, a marker length that is not positive, or a
  // camera with a defect.
  MarkerTracker(const TrackerOptions& options, const common::CameraModel& camera);

  // All markers of interest or of the board in a BGR or grey 8-bit image, repeated ids included.
  std::vector<tracking::DetectedMarker> detect(const cv::Mat& image) const;

  // One pose for each marker of interest, in ascending order of ids. Throws std::invalid_argument
  // if the image does not have the camera's size.
  std::vector<common::MarkerPose> track(const cv::Mat& image);
  std::vector<common::MarkerPose> track(const common::ImageRgb8& image);

  const tracking::TrackerCounts& counts() const { return poses_.counts(); }

 private:
  std::vector<common::MarkerPose> track_grey(const cv::Mat& grey);
  std::vector<tracking::DetectedMarker> detect_grey(const cv::Mat& grey) const;

  cv::Size size_;
  bool refine_corners_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
  tracking::PoseTracker poses_;
};

}  // namespace amalgam::client
