#include "bench/session.h"

#include <optional>

#include "core/timings.h"

namespace amalgam::bench {
namespace {

protocol::Envelope hello_with(const common::CameraModel& model) {
  protocol::Envelope envelope = test::hello_message();
  protocol::Camera& camera = *envelope.mutable_hello()->mutable_camera();
  camera.set_width(static_cast<std::uint32_t>(model.width));
  camera.set_height(static_cast<std::uint32_t>(model.height));
  camera.set_fx(model.fx);
  camera.set_fy(model.fy);
  camera.set_cx(model.cx);
  camera.set_cy(model.cy);
  return envelope;
}

protocol::Envelope frame_with(const frame::FrameInput& input) {
  const auto& jpeg = std::get<frame::Bytes>(input.image);
  protocol::Envelope envelope =
      test::frame_message(0, {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()});
  for (const common::MarkerPose& from : input.poses) {
    protocol::Pose& pose = *envelope.mutable_camera_frame()->add_poses();
    pose.set_marker(from.marker);
    pose.mutable_rotation()->set_x(from.rotation.x);
    pose.mutable_rotation()->set_y(from.rotation.y);
    pose.mutable_rotation()->set_z(from.rotation.z);
    pose.mutable_rotation()->set_w(from.rotation.w);
    pose.mutable_translation()->set_x(from.translation.x);
    pose.mutable_translation()->set_y(from.translation.y);
    pose.mutable_translation()->set_z(from.translation.z);
  }
  return envelope;
}

}  // namespace

Session::Session(const common::HostPort& server, const BenchCase& bench_case)
    : case_(bench_case), client_(server), frame_(frame_with(bench_case.input)) {
  client_.send(hello_with(case_.camera));
  client_.expect(protocol::Envelope::kWelcome);
}

void Session::send_frame() {
  frame_.mutable_camera_frame()->set_frame_id(++last_frame_);
  client_.send(frame_);
}

void Session::receive_composite() {
  last_answered_ = client_.expect(protocol::Envelope::kComposite).composite().frame_id();
}

double Session::round_trip_milliseconds() {
  const core::Stopwatch stopwatch;
  send_frame();
  receive_composite();
  return stopwatch.milliseconds();
}

double Session::frames_per_second(double seconds) {
  std::optional<core::Stopwatch> stopwatch;  // from the first composite on
  int frames = 0;
  while (!stopwatch || stopwatch->milliseconds() < 1000.0 * seconds) {
    while (last_frame_ - last_answered_ < 2) send_frame();
    receive_composite();
    if (stopwatch) {
      ++frames;
    } else {
      stopwatch.emplace();
    }
  }
  const double elapsed = stopwatch->milliseconds();
  // A newer frame may have replaced one that waited, but the last one is always answered.
  while (last_answered_ < last_frame_) receive_composite();
  return 1000.0 * frames / elapsed;
}

}  // namespace amalgam::bench
