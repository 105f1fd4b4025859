// Follows one board from image to image.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "tracking/board_pose.h"
#include "tracking/detected_marker.h"
#include "tracking/pose_disambiguation.h"

namespace amalgam::tracking {

class BoardTracker {
 public:
  // Throws std::runtime_error if the board has a defect.
  BoardTracker(MarkerBoard board, const common::CameraModel& camera);

  struct Tracked {
    std::optional<common::MarkerPose> pose;  // camera_from_board
    std::size_t repeated = 0;                // further markers with the same id: ignored
    std::size_t outliers = 0;                // markers that contradicted the others
  };
  // A board of two possible layouts has no pose until an image shows which one was printed: one
  // marker, or a row of them, fits both, in two places. frame counts images, as for
  // PoseDisambiguation. Of markers with the same id, takes the one that fits the last pose best, or
  // the largest if there is no last pose.
  Tracked track(std::span<const DetectedMarker> detected, std::uint64_t frame);

  const MarkerBoard& board() const { return board_; }

 private:
  // Takes the layout that the markers fit, and says if it is the older one.
  void choose_layout(std::span<const SeenBoardMarker> seen);

  MarkerBoard board_;  // without older_markers once the layout is known
  common::CameraModel camera_;
  PoseDisambiguation memory_;
};

// camera_from_marker of one of the board's markers.
common::MarkerPose pose_of(const BoardMarker& marker, const common::MarkerPose& camera_from_board);

}  // namespace amalgam::tracking
