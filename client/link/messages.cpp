#include "client/link/messages.h"

#include <algorithm>

#include "protocol/geometry.h"
#include "protocol/limits.h"

namespace amalgam::client {

protocol::Hello hello_message(const common::CameraModel& camera, const std::string& token,
                              int jpeg_quality) {
  protocol::Hello hello;
  hello.set_version(protocol::kProtocolVersion);
  hello.set_token(token);
  hello.set_jpeg_quality(static_cast<std::uint32_t>(jpeg_quality));
  *hello.mutable_camera() = protocol::to_message(camera);
  return hello;
}

protocol::Envelope frame_message(std::uint64_t frame_id, std::span<const unsigned char> jpeg,
                                 std::chrono::steady_clock::time_point captured_at,
                                 std::span<const common::MarkerPose> poses) {
  protocol::Envelope envelope;
  protocol::CameraFrame& out = *envelope.mutable_camera_frame();
  out.set_frame_id(frame_id);
  const auto since_epoch =
      std::chrono::duration_cast<std::chrono::microseconds>(captured_at.time_since_epoch());
  out.set_capture_time_us(static_cast<std::uint64_t>(since_epoch.count()));
  const std::size_t count = std::min(poses.size(), static_cast<std::size_t>(protocol::kMaxPoses));
  for (const common::MarkerPose& pose : poses.first(count))
    *out.add_poses() = protocol::to_message(pose);
  out.set_jpeg(jpeg.data(), jpeg.size());
  return envelope;
}

}  // namespace amalgam::client
