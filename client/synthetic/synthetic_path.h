// The path of the synthetic camera. It is known exactly, as ground truth for detected poses.
#pragma once

#include <cstdint>

#include "common/pose.h"

namespace amalgam::client {

inline constexpr std::uint64_t kSyntheticPeriod = 240;  // frames until the path repeats

// camera_from_marker at a frame (0, 1, ...), metres. The camera swings around the marker on the
// reader's side of the sheet, 0.35 to 0.6 m from a point just behind and above the marker, and
// never stands still.
common::MarkerPose synthetic_pose(std::uint64_t frame, int marker);

// camera_from_marker of a camera at a position that looks at a target, with the image's top towards
// +Z of the marker (out of the paper). Both in metres in OpenCV's marker frame, not straight above
// each other.
common::MarkerPose look_at(const glm::dvec3& position_in_marker, const glm::dvec3& target_in_marker,
                           int marker);

}  // namespace amalgam::client
