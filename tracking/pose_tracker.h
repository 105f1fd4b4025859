// From the markers found in each image to their poses, from image to image: chooses between a
// marker's two possible poses, between markers of the same id, and lets a board's markers give one
// pose together.
//
// Poses are camera_from_marker (common/pose.h). An unseen marker has no pose, unless it belongs to
// a board with seen markers. For one thread at a time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "tracking/board_tracker.h"
#include "tracking/detected_marker.h"
#include "tracking/pose_disambiguation.h"

namespace amalgam::tracking {

struct PoseTrackerOptions {
  double marker_length = 0.05;  // metres, side of the black square
  std::vector<int> ids{};       // markers of interest; empty: all
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

  TrackerCounts& operator+=(const TrackerCounts& other);
};

class PoseTracker {
 public:
  // Throws std::runtime_error for a marker length that is not positive, a camera or a board with a
  // defect.
  PoseTracker(const PoseTrackerOptions& options, const common::CameraModel& camera);

  // Whether a marker's corners are of any use.
  bool wants(int id) const { return is_of_interest(id) || is_on_board(id); }

  // One pose for each marker of interest, in ascending order of ids.
  std::vector<common::MarkerPose> track(std::span<const DetectedMarker> detected);

  const TrackerCounts& counts() const { return counts_; }

 private:
  using PosesById = std::map<int, common::MarkerPose>;
  bool is_of_interest(int id) const;
  bool is_on_board(int id) const;
  PosesById single_poses(std::span<const DetectedMarker> detected);
  void add_board_poses(std::span<const DetectedMarker> detected, PosesById& poses);

  PoseTrackerOptions options_;
  common::CameraModel camera_;
  std::map<int, PoseDisambiguation> memories_;
  std::optional<BoardTracker> board_;
  TrackerCounts counts_;
};

}  // namespace amalgam::tracking
