// Converts cameras and poses to messages and back, for clients and the server.
//
// Reading checks nothing. Check sizes before, because they are cast to int, and values after, by
// common::describe_defect and common::is_usable.
#pragma once

#include "common/camera_model.h"
#include "common/fisheye_model.h"
#include "common/pose.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::protocol {

Camera to_message(const common::CameraModel& camera);
common::CameraModel from_message(const Camera& message);  // at most kMaxDistortion coefficients

Pose to_message(const common::MarkerPose& pose);
common::MarkerPose from_message(const Pose& message);

Quaternion to_message(const glm::dquat& rotation);
glm::dquat from_message(const Quaternion& message);

// The lens alone; world_from_fisheye is a quaternion of its own.
Fisheye to_message(const common::FisheyeModel& lens);
common::FisheyeModel from_message(const Fisheye& message);

}  // namespace amalgam::protocol
