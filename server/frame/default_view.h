// Where to look at a scene from when no camera says: for pictures without a photograph, and for
// warming up.
#pragma once

#include "common/pose.h"

namespace amalgam::frame {

// A camera half a metre from the world marker that looks down at what stands on it.
common::MarkerPose default_pose(int world_marker);

}  // namespace amalgam::frame
