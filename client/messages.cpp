#include "client/messages.h"

#include <algorithm>

#include "protocol/limits.h"

namespace amalgam::client {
namespace {

void fill_pose(const core::MarkerPose& pose, protocol::Pose& out) {
  out.set_marker(pose.marker);
  protocol::Quaternion& rotation = *out.mutable_rotation();
  rotation.set_x(pose.rotation.x);
  rotation.set_y(pose.rotation.y);
  rotation.set_z(pose.rotation.z);
  rotation.set_w(pose.rotation.w);
  protocol::Vector3& translation = *out.mutable_translation();
  translation.set_x(pose.translation.x);
  translation.set_y(pose.translation.y);
  translation.set_z(pose.translation.z);
}

}  // namespace

protocol::Hello hello_message(const core::CameraModel& camera, const std::string& token,
                              int jpeg_quality) {
  protocol::Hello hello;
  hello.set_version(protocol::kProtocolVersion);
  hello.set_token(token);
  hello.set_jpeg_quality(static_cast<std::uint32_t>(jpeg_quality));
  protocol::Camera& out = *hello.mutable_camera();
  out.set_width(static_cast<std::uint32_t>(camera.width));
  out.set_height(static_cast<std::uint32_t>(camera.height));
  out.set_fx(camera.fx);
  out.set_fy(camera.fy);
  out.set_cx(camera.cx);
  out.set_cy(camera.cy);
  if (camera.has_distortion()) {
    for (const double coefficient : camera.distortion) out.add_distortion(coefficient);
  }
  return hello;
}

protocol::Envelope frame_message(std::uint64_t frame_id, const CapturedFrame& frame,
                                 std::span<const core::MarkerPose> poses) {
  protocol::Envelope envelope;
  protocol::CameraFrame& out = *envelope.mutable_camera_frame();
  out.set_frame_id(frame_id);
  const auto since_epoch =
      std::chrono::duration_cast<std::chrono::microseconds>(frame.captured_at.time_since_epoch());
  out.set_capture_time_us(static_cast<std::uint64_t>(since_epoch.count()));
  const std::size_t count = std::min(poses.size(), static_cast<std::size_t>(protocol::kMaxPoses));
  for (const core::MarkerPose& pose : poses.first(count)) fill_pose(pose, *out.add_poses());
  out.set_jpeg(frame.jpeg.data(), frame.jpeg.size());
  return envelope;
}

}  // namespace amalgam::client
