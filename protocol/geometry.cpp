#include "protocol/geometry.h"

#include <algorithm>

namespace amalgam::protocol {
namespace {

// What pinhole cameras and fish-eye lenses have in common, by the same names.
template <typename Message, typename Model>
void write_intrinsics(const Model& model, Message& message) {
  message.set_width(static_cast<std::uint32_t>(model.width));
  message.set_height(static_cast<std::uint32_t>(model.height));
  message.set_fx(model.fx);
  message.set_fy(model.fy);
  message.set_cx(model.cx);
  message.set_cy(model.cy);
}

template <typename Message, typename Model>
void read_intrinsics(const Message& message, Model& model) {
  model.width = static_cast<int>(message.width());
  model.height = static_cast<int>(message.height());
  model.fx = message.fx();
  model.fy = message.fy();
  model.cx = message.cx();
  model.cy = message.cy();
}

}  // namespace

Camera to_message(const common::CameraModel& camera) {
  Camera message;
  write_intrinsics(camera, message);
  if (camera.has_distortion()) {
    message.mutable_distortion()->Add(camera.distortion.begin(), camera.distortion.end());
  }
  return message;
}

common::CameraModel from_message(const Camera& message) {
  common::CameraModel camera;
  read_intrinsics(message, camera);
  std::copy(message.distortion().begin(), message.distortion().end(), camera.distortion.begin());
  return camera;
}

Pose to_message(const common::MarkerPose& pose) {
  Pose message;
  message.set_marker(pose.marker);
  *message.mutable_rotation() = to_message(pose.rotation);
  Vector3& translation = *message.mutable_translation();
  translation.set_x(pose.translation.x);
  translation.set_y(pose.translation.y);
  translation.set_z(pose.translation.z);
  return message;
}

common::MarkerPose from_message(const Pose& message) {
  const Vector3& translation = message.translation();
  return {message.marker(), from_message(message.rotation()),
          glm::dvec3(translation.x(), translation.y(), translation.z())};
}

Quaternion to_message(const glm::dquat& rotation) {
  Quaternion message;
  message.set_x(rotation.x);
  message.set_y(rotation.y);
  message.set_z(rotation.z);
  message.set_w(rotation.w);
  return message;
}

glm::dquat from_message(const Quaternion& message) {
  return {message.w(), message.x(), message.y(), message.z()};
}

Fisheye to_message(const common::FisheyeModel& lens) {
  Fisheye message;
  write_intrinsics(lens, message);
  message.set_max_angle(lens.max_angle);
  return message;
}

common::FisheyeModel from_message(const Fisheye& message) {
  common::FisheyeModel lens;
  read_intrinsics(message, lens);
  lens.max_angle = message.max_angle();
  return lens;
}

}  // namespace amalgam::protocol
