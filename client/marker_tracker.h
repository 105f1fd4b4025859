// Finds ArUco markers in camera images and says where they are, frame after frame.
//
// Poses are camera_from_marker (core/pose.h). A marker that is not seen has no entry: holding a
// last good pose is the server's. Used by one thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <opencv2/aruco.hpp>
#include <string>
#include <vector>

#include "client/pose_memory.h"
#include "client/square_pose.h"
#include "core/camera_model.h"
#include "core/image.h"
#include "core/pose.h"

namespace amalgam::client {

struct TrackerOptions {
  std::string dictionary = "DICT_6X6_250";  // see find_dictionary()
  double marker_length = 0.05;              // metres, side of the black square
  std::vector<int> ids{};                   // markers of interest; empty: all of the dictionary
  bool refine_corners = true;               // to fractions of a pixel; poses want it
};

struct DetectedMarker {
  int id = 0;
  SquareCorners corners{};
};

struct TrackerCounts {
  std::uint64_t images = 0;
  std::uint64_t poses = 0;
  std::uint64_t repeated = 0;  // further markers with an id that the image held already: ignored
  std::uint64_t unsolved = 0;  // markers found whose corners gave no usable pose
};

class MarkerTracker {
 public:
  // Throws std::runtime_error for an unknown dictionary, a marker length that is not positive, or a
  // camera with a defect.
  MarkerTracker(const TrackerOptions& options, const core::CameraModel& camera);

  // Every marker of interest in a BGR or grey 8-bit image, repeated ids included.
  std::vector<DetectedMarker> detect(const cv::Mat& image) const;

  // One pose for each marker id, in ascending order of ids. The image must have the camera's size;
  // throws std::invalid_argument if it has not.
  std::vector<core::MarkerPose> track(const cv::Mat& image);
  std::vector<core::MarkerPose> track(const core::ImageRgb8& image);

  const TrackerCounts& counts() const { return counts_; }

 private:
  std::vector<core::MarkerPose> track_grey(const cv::Mat& grey);
  std::vector<DetectedMarker> detect_grey(const cv::Mat& grey) const;

  TrackerOptions options_;
  core::CameraModel camera_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
  std::map<int, PoseMemory> memories_;
  TrackerCounts counts_;
};

}  // namespace amalgam::client
