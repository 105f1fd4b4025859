#include "net/wire.h"

#include <algorithm>
#include <string>

#include "protocol/limits.h"

namespace amalgam::net {
namespace {

using protocol::Error;

core::CameraModel camera_from(const protocol::Camera& wire) {
  // Before the cast to int, and before anything looks at the camera's pixels.
  if (wire.width() > protocol::kMaxSide || wire.height() > protocol::kMaxSide ||
      std::uint64_t{wire.width()} * wire.height() > protocol::kMaxPixels) {
    throw ClientError(Error::BAD_HELLO, "images of " + std::to_string(wire.width()) + " x " +
                                            std::to_string(wire.height()) +
                                            " pixels; at most 2048 x 2048 are accepted");
  }
  if (wire.distortion_size() > protocol::kMaxDistortion) {
    throw ClientError(Error::BAD_HELLO, std::to_string(wire.distortion_size()) +
                                            " distortion coefficients; at most 12 are accepted");
  }
  core::CameraModel camera;
  camera.width = static_cast<int>(wire.width());
  camera.height = static_cast<int>(wire.height());
  camera.fx = wire.fx();
  camera.fy = wire.fy();
  camera.cx = wire.cx();
  camera.cy = wire.cy();
  std::copy(wire.distortion().begin(), wire.distortion().end(), camera.distortion.begin());
  return camera;
}

}  // namespace

frame::ViewOptions view_options_from(const protocol::Hello& hello) {
  if (!hello.has_camera()) throw ClientError(Error::BAD_HELLO, "a hello without a camera");
  frame::ViewOptions options;
  options.camera = camera_from(hello.camera());
  if (const std::string defect = core::describe_defect(options.camera); !defect.empty()) {
    throw ClientError(Error::BAD_HELLO, defect);
  }
  if (hello.jpeg_quality() > protocol::kMaxJpegQuality) {
    throw ClientError(Error::BAD_HELLO, "a JPEG quality of " +
                                            std::to_string(hello.jpeg_quality()) +
                                            "; 1 to 100 are accepted, 0 is the default");
  }
  options.jpeg_quality = static_cast<int>(hello.jpeg_quality());
  return options;
}

std::vector<core::MarkerPose> poses_from(const protocol::CameraFrame& frame) {
  std::vector<core::MarkerPose> poses;
  poses.reserve(static_cast<std::size_t>(frame.poses_size()));
  for (const protocol::Pose& wire : frame.poses()) {
    const protocol::Quaternion& q = wire.rotation();
    const protocol::Vector3& t = wire.translation();
    poses.push_back(
        {wire.marker(), glm::dquat(q.w(), q.x(), q.y(), q.z()), glm::dvec3(t.x(), t.y(), t.z())});
  }
  return poses;
}

frame::Bytes bytes_from(std::string_view bytes) {
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes.data());
  return frame::Bytes(begin, begin + bytes.size());
}

protocol::Envelope welcome_message(std::uint64_t session, const SessionLimits& limits,
                                   const frame::FrameService::MarkerSet& markers) {
  protocol::Envelope envelope;
  protocol::Welcome& welcome = *envelope.mutable_welcome();
  welcome.set_session(session);
  protocol::Limits& wire = *welcome.mutable_limits();
  wire.set_max_message_bytes(static_cast<std::uint32_t>(protocol::kMaxCameraFrameBytes));
  wire.set_max_poses(static_cast<std::uint32_t>(protocol::kMaxPoses));
  wire.set_ping_interval_ms(static_cast<std::uint32_t>(limits.ping_interval.count()));
  wire.set_idle_timeout_ms(static_cast<std::uint32_t>(limits.idle_timeout.count()));
  protocol::Markers& wanted = *welcome.mutable_markers();
  wanted.set_dictionary(markers.dictionary);
  wanted.set_length(markers.marker_length);
  wanted.set_world_marker(markers.world_marker);
  wanted.mutable_ids()->Add(markers.ids.begin(), markers.ids.end());
  return envelope;
}

protocol::Envelope error_message(const ClientError& error) {
  protocol::Envelope envelope;
  Error& wire = *envelope.mutable_error();
  wire.set_code(error.code);
  wire.set_text(error.what());
  wire.set_frame_id(error.frame_id);
  wire.set_closes(!is_survivable(error.code));
  return envelope;
}

protocol::Composite composite_from(const frame::FrameOutput& output) {
  const frame::FrameStatistics& statistics = output.statistics;
  protocol::Composite composite;
  composite.set_jpeg(output.jpeg.data(), output.jpeg.size());
  composite.set_unchanged(output.unchanged);
  for (const core::StageTime& time : statistics.stages) {
    protocol::Stage& stage = *composite.add_stages();
    stage.set_name(time.stage);
    stage.set_milliseconds(time.milliseconds);
  }
  for (const frame::PassRecord& record : statistics.passes) {
    protocol::Pass& pass = *composite.add_passes();
    pass.set_name(record.name);
    pass.set_ran(record.ran);
    pass.set_reason(record.reason);
  }
  protocol::Rays& rays = *composite.mutable_rays();
  rays.set_primary(statistics.rays.primary);
  rays.set_reflection(statistics.rays.reflection);
  rays.set_refraction(statistics.rays.refraction);
  rays.set_shadow(statistics.rays.shadow);
  rays.set_lookup(statistics.rays.lookup);
  protocol::Pixels& pixels = *composite.mutable_pixels();
  pixels.set_virtual_pixels(statistics.pixels.virtual_pixels);
  pixels.set_specular(statistics.pixels.specular);
  pixels.set_total(statistics.pixels.total);
  composite.set_nonfinite(statistics.nonfinite);
  return composite;
}

protocol::Pose pose_to_wire(const core::MarkerPose& pose) {
  protocol::Pose wire;
  wire.set_marker(pose.marker);
  protocol::Quaternion& q = *wire.mutable_rotation();
  q.set_x(pose.rotation.x);
  q.set_y(pose.rotation.y);
  q.set_z(pose.rotation.z);
  q.set_w(pose.rotation.w);
  protocol::Vector3& t = *wire.mutable_translation();
  t.set_x(pose.translation.x);
  t.set_y(pose.translation.y);
  t.set_z(pose.translation.z);
  return wire;
}

}  // namespace amalgam::net
