// Finds ArUco markers in camera images and their poses, from frame to frame.
//
// Poses are camera_from_marker (common/pose.h). An unseen marker has no entry, unless it belongs to
// a board with seen markers; the server holds last good poses. For one thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <opencv2/aruco.hpp>
#include <optional>
#include <string>
#include <vector>

#include "client/board_tracker.h"
#include "client/pose_disambiguation.h"
#include "client/square_pose.h"
#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"

namespace amalgam::client {

struct TrackerOptions {
  std::string dictionary = "DICT_6X6_250";  // see find_dictionary()
  double marker_length = 0.05;              // metres, side of the black square
  std::vector<int> ids{};                   // markers of interest; empty: all of the dictionary
  bool refine_corners = true;               // to fractions of a pixel, as poses need
  // Markers that are fixed to each other. Their poses, and the world marker's, come from all of
  // them together, whether the world marker is part of the board or not: see placed_on().
  std::optional<MarkerBoard> board{};
  int world_marker = -1;  // needed only with a board
};

struct TrackerCounts {
  std::uint64_t images = 0;
  std::uint64_t poses = 0;
  std::uint64_t repeated = 0;        // further markers with the same id in one image: ignored
  std::uint64_t unsolved = 0;        // markers found whose corners gave no usable pose
  std::uint64_t board_poses = 0;     // images in which the board had a pose
  std::uint64_t board_outliers = 0;  // markers of the board that contradicted its others
};

class MarkerTracker {
 public:
  // Throws std::runtime_error for an unknown dictionary, a marker length that is not positive, or a
  // camera with a defect.
  MarkerTracker(const TrackerOptions& options, const common::CameraModel& camera);

  // All markers of interest or of the board in a BGR or grey 8-bit image, repeated ids included.
  std::vector<DetectedMarker> detect(const cv::Mat& image) const;

  // One pose for each marker of interest, in ascending order of ids. Throws std::invalid_argument
  // if the image does not have the camera's size.
  std::vector<common::MarkerPose> track(const cv::Mat& image);
  std::vector<common::MarkerPose> track(const common::ImageRgb8& image);

  const TrackerCounts& counts() const { return counts_; }

 private:
  std::vector<common::MarkerPose> track_grey(const cv::Mat& grey);
  std::vector<DetectedMarker> detect_grey(const cv::Mat& grey) const;
  bool is_of_interest(int id) const;
  std::map<int, common::MarkerPose> single_poses(const std::vector<DetectedMarker>& detected);
  void add_board_poses(const std::vector<DetectedMarker>& detected,
                       std::map<int, common::MarkerPose>& poses);

  TrackerOptions options_;
  common::CameraModel camera_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
  std::map<int, PoseDisambiguation> memories_;
  std::optional<BoardTracker> board_;
  TrackerCounts counts_;
};

}  // namespace amalgam::client
