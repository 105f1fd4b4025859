// Finds ArUco markers in camera images and says where they are, frame after frame.
//
// Poses are camera_from_marker (common/pose.h). A marker that is not seen has no entry, unless it
// belongs to a board of which others are seen: holding a last good pose is the server's. Used by
// one thread at a time.
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
  bool refine_corners = true;               // to fractions of a pixel; poses want it
  // Markers that are fixed to one another. Theirs are the poses that all of them together give, and
  // the world marker's too, whether it is part of the board or not: see placed_on().
  std::optional<MarkerBoard> board{};
  int world_marker = -1;  // of interest with a board only
};

struct TrackerCounts {
  std::uint64_t images = 0;
  std::uint64_t poses = 0;
  std::uint64_t repeated = 0;     // further markers with an id that the image held already: ignored
  std::uint64_t unsolved = 0;     // markers found whose corners gave no usable pose
  std::uint64_t board_poses = 0;  // images in which the board had a pose
  std::uint64_t board_outliers = 0;  // markers of the board that contradicted its others
};

class MarkerTracker {
 public:
  // Throws std::runtime_error for an unknown dictionary, a marker length that is not positive, or a
  // camera with a defect.
  MarkerTracker(const TrackerOptions& options, const common::CameraModel& camera);

  // Every marker of interest or of the board in a BGR or grey 8-bit image, repeated ids included.
  std::vector<DetectedMarker> detect(const cv::Mat& image) const;

  // One pose for each marker of interest, in ascending order of ids. The image must have the
  // camera's size; throws std::invalid_argument if it has not.
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
