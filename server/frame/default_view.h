// The view of a scene without a camera: for pictures without a photograph, and for warming up.
#pragma once

#include "common/pose.h"

namespace amalgam::frame {

// A camera half a metre from the world marker, looking down at its objects.
common::MarkerPose default_pose(int world_marker);

}  // namespace amalgam::frame
