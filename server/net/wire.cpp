#include "net/wire.h"

#include <algorithm>
#include <string>

#include "common/build_info.h"
#include "protocol/geometry.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

using protocol::Error;

// Before the cast to int, and before anything looks at the image's pixels.
void check_size(std::uint32_t width, std::uint32_t height, Error::Code code) {
  if (width > protocol::kMaxSide || height > protocol::kMaxSide ||
      std::uint64_t{width} * height > protocol::kMaxPixels) {
    const std::string side = std::to_string(protocol::kMaxSide);
    throw ClientError(code, "images of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels; at most " + side + " x " + side + " are accepted");
  }
}

common::CameraModel camera_from(const protocol::Camera& wire) {
  check_size(wire.width(), wire.height(), Error::BAD_HELLO);
  if (wire.distortion_size() > protocol::kMaxDistortion) {
    throw ClientError(Error::BAD_HELLO, std::to_string(wire.distortion_size()) +
                                            " distortion coefficients; at most " +
                                            std::to_string(protocol::kMaxDistortion) +
                                            " are accepted");
  }
  return protocol::from_message(wire);
}

}  // namespace

Rights check_admission(const protocol::Hello& hello, const std::vector<Grant>& grants) {
  if (hello.version() != protocol::kProtocolVersion) {
    throw ClientError(Error::UNSUPPORTED_VERSION, "version " + std::to_string(hello.version()) +
                                                      "; this server speaks " +
                                                      std::to_string(protocol::kProtocolVersion));
  }
  const std::optional<Rights> rights = rights_of(hello.token(), grants);
  if (!rights) throw ClientError(Error::AUTH_FAILED, "the token is wrong");
  return *rights;
}

frame::ViewOptions view_options_from(const protocol::Hello& hello) {
  if (!hello.has_camera()) throw ClientError(Error::BAD_HELLO, "a hello without a camera");
  frame::ViewOptions options;
  options.camera = camera_from(hello.camera());
  if (const std::string defect = common::describe_defect(options.camera); !defect.empty()) {
    throw ClientError(Error::BAD_HELLO, defect);
  }
  if (hello.jpeg_quality() > protocol::kMaxJpegQuality) {
    throw ClientError(Error::BAD_HELLO, "a JPEG quality of " +
                                            std::to_string(hello.jpeg_quality()) + "; 1 to " +
                                            std::to_string(protocol::kMaxJpegQuality) +
                                            " are accepted, 0 is the default");
  }
  options.jpeg_quality = static_cast<int>(hello.jpeg_quality());
  return options;
}

std::vector<common::MarkerPose> poses_from(const protocol::CameraFrame& frame) {
  std::vector<common::MarkerPose> poses;
  poses.reserve(static_cast<std::size_t>(frame.poses_size()));
  for (const protocol::Pose& wire : frame.poses()) {
    poses.push_back(protocol::from_message(wire));
  }
  return poses;
}

frame::EnvironmentInput environment_from(const protocol::Environment& environment) {
  if (environment.image().empty()) {
    throw ClientError(Error::BAD_ENVIRONMENT, "an environment without an image");
  }
  frame::EnvironmentInput input;
  if (environment.has_fisheye()) {
    const protocol::Fisheye& wire = environment.fisheye();
    check_size(wire.width(), wire.height(), Error::BAD_ENVIRONMENT);
    input.projection = frame::EnvironmentInput::Projection::Fisheye;
    input.fisheye = protocol::from_message(wire);
    const std::string defect = common::describe_defect(input.fisheye);
    if (!defect.empty()) throw ClientError(Error::BAD_ENVIRONMENT, "fish-eye lens: " + defect);
    common::MarkerPose turn;  // a rotation is judged as that of a pose
    turn.rotation = protocol::from_message(wire.world_from_fisheye());
    if (!common::is_usable(turn)) {
      throw ClientError(Error::BAD_ENVIRONMENT,
                        "fish-eye lens: its rotation is not of unit length");
    }
    input.world_from_fisheye = glm::normalize(turn.rotation);
  }
  input.image = bytes_from(environment.image());
  return input;
}

frame::Bytes bytes_from(std::string_view bytes) {
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes.data());
  return frame::Bytes(begin, begin + bytes.size());
}

protocol::Envelope welcome_message(std::uint64_t session, const SessionLimits& limits,
                                   const frame::FrameService::MarkerSet& markers,
                                   const protocol::Fingerprint& fingerprint) {
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
  *welcome.mutable_fingerprint() = fingerprint;
  return envelope;
}

protocol::Fingerprint fingerprint_message(const frame::FrameService::Fingerprint& renderer) {
  protocol::Fingerprint message;
  message.set_build(std::string(common::version()) + ", " + common::instruction_set() + ", " +
                    common::build_id());
  message.set_scene(renderer.scene);
  message.set_scene_hash(renderer.scene_hash);
  message.set_options(renderer.options);
  message.set_hardware(renderer.hardware);
  return message;
}

protocol::Envelope ping_message(std::uint64_t nonce) {
  protocol::Envelope envelope;
  envelope.mutable_ping()->set_nonce(nonce);
  return envelope;
}

protocol::Envelope pong_message(std::uint64_t nonce) {
  protocol::Envelope envelope;
  envelope.mutable_pong()->set_nonce(nonce);
  return envelope;
}

protocol::Envelope busy_message(std::chrono::milliseconds retry_after, const std::string& reason) {
  protocol::Envelope envelope;
  protocol::Busy& busy = *envelope.mutable_busy();
  busy.set_retry_after_ms(static_cast<std::uint32_t>(retry_after.count()));
  busy.set_reason(reason);
  return envelope;
}

protocol::Envelope draining_message(std::chrono::milliseconds deadline) {
  protocol::Envelope envelope;
  envelope.mutable_draining()->set_deadline_ms(static_cast<std::uint32_t>(deadline.count()));
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

ClientError poses_rejected(const std::vector<int>& markers, std::uint64_t frame_id) {
  std::string text =
      "poses that are not finite, not of unit length or too far, or corners that are not four "
      "places near the image, of markers";
  for (const int marker : markers) text.append(" ").append(std::to_string(marker));
  return {Error::POSE_REJECTED, text, frame_id};
}

namespace {

protocol::Quality::Bound bound_from(frame::FrameQuality::Bound bound) {
  using Bound = frame::FrameQuality::Bound;
  switch (bound) {
    case Bound::Nothing:
      return protocol::Quality::NOTHING;
    case Bound::Trace:
      return protocol::Quality::TRACE;
    case Bound::Raster:
      return protocol::Quality::RASTER;
    case Bound::Encode:
      return protocol::Quality::ENCODE;
    case Bound::Lowest:
      return protocol::Quality::LOWEST;
  }
  return protocol::Quality::NOTHING;
}

protocol::Quality quality_from(const frame::FrameQuality& chosen) {
  protocol::Quality quality;
  quality.set_level(static_cast<std::uint32_t>(chosen.level));
  quality.set_lowest_level(static_cast<std::uint32_t>(chosen.lowest_level));
  quality.set_samples_per_pixel(static_cast<std::uint32_t>(chosen.samples_per_pixel));
  quality.set_adaptive(chosen.adaptive);
  quality.set_max_depth(static_cast<std::uint32_t>(chosen.max_depth));
  quality.set_importance_cutoff(chosen.importance_cutoff);
  quality.set_render_scale(chosen.render_scale);
  quality.set_jpeg_quality(static_cast<std::uint32_t>(chosen.jpeg_quality));
  quality.set_bound(bound_from(chosen.bound));
  return quality;
}

}  // namespace

protocol::Envelope composite_message(const Answer& answer, std::uint64_t skipped) {
  const frame::FrameOutput& output = answer.output;
  const frame::FrameStatistics& statistics = output.statistics;
  protocol::Envelope envelope;
  protocol::Composite& composite = *envelope.mutable_composite();
  composite.set_frame_id(answer.frame.frame_id);
  composite.set_capture_time_us(answer.frame.capture_time_us);
  composite.set_server_ms(answer.server_ms);
  composite.set_skipped(skipped);
  for (const common::MarkerPose& pose : answer.frame.poses) {
    *composite.add_poses() = protocol::to_message(pose);
  }
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
  rays.set_reused(statistics.rays.reused);
  protocol::Pixels& pixels = *composite.mutable_pixels();
  pixels.set_virtual_pixels(statistics.pixels.virtual_pixels);
  pixels.set_specular(statistics.pixels.specular);
  pixels.set_total(statistics.pixels.total);
  composite.set_nonfinite(statistics.nonfinite);
  composite.mutable_truncation_bound()->set_mean(statistics.truncation_bound.mean);
  composite.mutable_truncation_bound()->set_worst(statistics.truncation_bound.worst);
  if (statistics.quality) *composite.mutable_quality() = quality_from(*statistics.quality);
  return envelope;
}

}  // namespace amalgam::net
