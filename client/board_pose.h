// A board's pose from the corners of all its markers that are seen.
//
// Seen corners are freed of lens distortion by common::pixel_direction, solved by IPPE [Collins &
// Bartoli 2014] where they lie in a plane and by SQPnP [Terzakis & Lourakis 2020] where not, and
// refined by Levenberg-Marquardt. A marker that contradicts the others (misread, or moved on its
// own) is left out.
#pragma once

#include <span>
#include <vector>

#include "client/marker_board.h"
#include "client/square_pose.h"

namespace amalgam::client {

struct SeenBoardMarker {
  const BoardMarker* marker = nullptr;
  SquareCorners corners{};  // pixels of the (distorted) image
};

struct BoardFit {
  // None, one or two (of a flat board), the better one first. camera_from_board; errors are of the
  // corners that were used, in pixels of the image. None if the best one's error is beyond ten
  // times the limit for outliers: two markers that contradict each other do not say which of them
  // is wrong.
  std::vector<PoseSolution> solutions;
  std::vector<int> outliers;  // ids of markers that were left out
};

// A marker is left out if its corners are off by more than a 320th of the image's width (root mean
// square; 2 pixels at 640) and by three times as much as those of the others, once the pose is
// found without it; never more than half of the markers.
BoardFit solve_board(std::span<const SeenBoardMarker> seen, const common::CameraModel& camera);

// Root mean square distance between a marker's corners in the image and where this pose of the
// board puts them, pixels; infinite if it puts them behind the camera or the lens cannot see them.
double reprojection_error(const SeenBoardMarker& seen, const common::MarkerPose& camera_from_board,
                          const common::CameraModel& camera);

}  // namespace amalgam::client
