// A board's pose from the corners of all its seen markers.
//
// Corners are undistorted by common::pixel_direction. The pose is solved by IPPE [Collins & Bartoli
// 2014] if the corners lie in a plane, by SQPnP [Terzakis & Lourakis 2020] otherwise, and refined
// by Levenberg-Marquardt. A marker that contradicts the others (misread, or moved on its own) is
// left out.
#pragma once

#include <span>
#include <vector>

#include "tracking/marker_board.h"
#include "tracking/square_pose.h"

namespace amalgam::tracking {

struct SeenBoardMarker {
  const BoardMarker* marker = nullptr;
  SquareCorners corners{};  // pixels of the (distorted) image
};

struct BoardFit {
  // camera_from_board: none, one or two (of a flat board), the better one first. Errors are of the
  // used corners, in pixels of the image. None if the best error exceeds ten times the limit for
  // outliers: of two markers that contradict each other, it is unknown which is wrong.
  std::vector<PoseSolution> solutions;
  std::vector<int> outliers;  // ids of markers that were left out
};

// A marker is left out if, with the pose found without it, its corners are off by more than a 320th
// of the image's width (root mean square; 2 pixels at 640) and by three times as much as those of
// the others. Never leaves out more than half of the markers.
BoardFit solve_board(std::span<const SeenBoardMarker> seen, const common::CameraModel& camera);

// Root mean square distance between a marker's corners in the image and their projections with this
// pose, pixels. Infinite if a corner cannot be projected.
double reprojection_error(const SeenBoardMarker& seen, const common::MarkerPose& camera_from_board,
                          const common::CameraModel& camera);

}  // namespace amalgam::tracking
