// A view onto a scene when no camera says otherwise: for pictures without a photograph, and for
// warming up.
#pragma once

#include "core/camera_model.h"
#include "core/pose.h"

namespace amalgam::frame {

// 60 degrees wide, square pixels, no distortion.
core::CameraModel default_camera(int width, int height);

// A camera half a metre from the world marker that looks down at what stands on it.
core::MarkerPose default_pose(int world_marker);

}  // namespace amalgam::frame
