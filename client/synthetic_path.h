// The path of the synthetic camera: known exactly, so that detected poses have something to be
// compared with.
#pragma once

#include <cstdint>

#include "common/pose.h"

namespace amalgam::client {

inline constexpr std::uint64_t kSyntheticPeriod = 240;  // frames until the path repeats

// Where the marker is in the camera's frame at a frame (0, 1, ...): camera_from_marker, metres. The
// camera swings around the marker on the reader's side of the sheet, 0.35 to 0.6 m from a point
// just behind and above the marker, and never stands still.
common::MarkerPose synthetic_pose(std::uint64_t frame, int marker);

// The pose of a camera at a position that looks at a target, with the image's top towards +Z of the
// marker (out of the paper). Both in metres in OpenCV's marker frame; not straight above one
// another.
common::MarkerPose look_at(const glm::dvec3& position_in_marker, const glm::dvec3& target_in_marker,
                           int marker);

}  // namespace amalgam::client
