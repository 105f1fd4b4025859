// Cameras and poses as they go over the wire: both directions, for clients and for the server.
//
// Reading checks nothing: sizes must have been judged before (they are cast to int), and values
// are judged after, by core::describe_defect and core::is_usable.
#pragma once

#include "core/camera_model.h"
#include "core/fisheye_model.h"
#include "core/pose.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::protocol {

Camera to_message(const core::CameraModel& camera);
core::CameraModel from_message(const Camera& message);  // at most kMaxDistortion coefficients

Pose to_message(const core::MarkerPose& pose);
core::MarkerPose from_message(const Pose& message);

Quaternion to_message(const glm::dquat& rotation);
glm::dquat from_message(const Quaternion& message);

// The lens alone; world_from_fisheye is a quaternion of its own.
Fisheye to_message(const core::FisheyeModel& lens);
core::FisheyeModel from_message(const Fisheye& message);

}  // namespace amalgam::protocol
