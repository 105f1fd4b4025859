#include "client/viewer.h"

#include <algorithm>

#include "client/link/messages.h"
#include "common/log.h"
#include "protocol/framing.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::client {
namespace {

using std::chrono::milliseconds;

// The longest delay until a signal or a key press is noticed.
constexpr milliseconds kMaxWait{50};
constexpr int kMaxEventsAFrame = 256;
// Time for the last answers. A live server answers or pings well before.
constexpr std::chrono::seconds kFinishTimeout{30};

}  // namespace

Viewer::Viewer(const ViewerOptions& options, const common::CameraModel& camera,
               CameraSource& source, FrameSink* sink, Connection& connection,
               const std::atomic<bool>& stop)
    : options_(options),
      camera_(camera),
      source_(source),
      sink_(sink),
      connection_(connection),
      stop_(stop) {
  if (options.smoothing) smoother_.emplace(*options.smoothing);
}

ViewerSummary Viewer::run() {
  if (wait_for_welcome()) {
    const Clock::time_point start = Clock::now();
    stream();
    finish();
    summary_.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  summary_.frames = in_flight_.counts();
  summary_.latency = in_flight_.latency();
  if (smoother_) summary_.smoothing = smoother_->report();
  add_counts();
  return summary_;
}

void Viewer::add_counts() {
  if (tracker_) summary_.markers += tracker_->counts();
  if (dead_band_) summary_.poses_held += dead_band_->held();
}

bool Viewer::wait_for_welcome() {
  while (!tracker_ && !is_stopped()) handle_next(kMaxWait);
  return tracker_.has_value() && !is_stopped();
}

void Viewer::stream() {
  const auto interval = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / options_.rate));
  Clock::time_point due = Clock::now();
  while (!is_stopped() && (options_.frames == 0 || last_id_ < options_.frames)) {
    const auto frame = source_.next();
    if (!frame) return;
    send(*frame);
    // No more in a turn, so that a flood of events does not keep the camera waiting.
    for (int i = 0; i < kMaxEventsAFrame && handle_next(milliseconds(0)); ++i) {
    }
    while (options_.lockstep && in_flight_.has_open() && !is_stopped()) handle_next(kMaxWait);
    if (options_.lockstep || source_.is_live()) continue;
    // A machine that cannot keep the rate sends as fast as it can, and does not catch up in a
    // burst.
    due = std::max(due + interval, Clock::now() - interval);
    while (Clock::now() < due && !is_stopped()) {
      handle_next(std::min(std::chrono::ceil<milliseconds>(due - Clock::now()), kMaxWait));
    }
  }
}

void Viewer::finish() {
  const Clock::time_point deadline = Clock::now() + kFinishTimeout;
  while (in_flight_.has_open() && !is_stopped() && Clock::now() < deadline) {
    handle_next(kMaxWait);
  }
  in_flight_.lost_up_to(last_id_);
}

void Viewer::send(const CapturedFrame& frame) {
  const std::uint64_t id = ++last_id_;
  in_flight_.captured(id, frame.captured_at);
  std::vector<common::MarkerPose> poses =
      frame.true_poses ? *frame.true_poses : tracker_->track(frame.bgr);
  if (smoother_) poses = smoother_->smooth(std::move(poses), frame.captured_at);
  if (dead_band_) poses = dead_band_->hold(std::move(poses));
  if (!poses.empty()) summary_.last_poses = poses;
  std::string bytes = protocol::encode(frame_message(id, frame.jpeg, frame.captured_at, poses));
  if (const auto replaced = connection_.send(id, std::move(bytes))) in_flight_.skipped(*replaced);
}

bool Viewer::handle_next(milliseconds timeout) {
  auto event = connection_.wait(timeout);
  if (event) std::visit([this](auto& happened) { handle(happened); }, *event);
  if (sink_ != nullptr && sink_->wants_to_stop()) stopped_by_user_ = true;
  return event.has_value();
}

void Viewer::handle(Welcomed& event) {
  if (tracker_) ++summary_.reconnects;
  const protocol::Markers& markers = event.welcome.markers();
  // Only another scene makes the tracker forget what it knows.
  const std::string as_text = markers.SerializeAsString();
  if (tracker_ && as_text == markers_) return;
  markers_ = as_text;
  TrackerOptions options;
  options.dictionary = tracking::predefined_dictionary(markers.dictionary());
  options.marker_length = markers.length();
  options.ids.assign(markers.ids().begin(), markers.ids().end());
  options.board = options_.board;
  options.world_marker = markers.world_marker();
  add_counts();
  tracker_.emplace(options, camera_);
  if (options_.dead_band > 0.0)
    dead_band_.emplace(options_.dead_band, options.marker_length, camera_);
}

void Viewer::handle(Composited& event) {
  const protocol::Composite& composite = event.composite;
  if (!in_flight_.is_open(composite.frame_id())) return;
  in_flight_.composited(composite.frame_id(), composite.unchanged(), event.at);
  if (sink_ == nullptr) return;
  const auto* bytes = reinterpret_cast<const unsigned char*>(composite.jpeg().data());
  sink_->show(composite.frame_id(), {bytes, composite.jpeg().size()});
}

void Viewer::handle(FrameError& event) {
  ++summary_.server_errors;
  summary_.last_error = protocol::Error::Code_Name(event.error.code()) + ": " + event.error.text();
  common::log_warn("frame " + std::to_string(event.error.frame_id()) + ": " + summary_.last_error);
  // A frame with a bad pose is still rendered, with the last good one or without; an environment
  // is no frame.
  const auto code = event.error.code();
  if (code == protocol::Error::POSE_REJECTED || code == protocol::Error::BAD_ENVIRONMENT) return;
  in_flight_.rejected(event.error.frame_id());
}

void Viewer::handle(LinkBroken& event) {
  common::log_warn("connection lost (" + event.text + "), reconnecting");
  in_flight_.lost_up_to(event.last_sent);
}

void Viewer::handle(GaveUp& event) {
  summary_.gave_up = true;
  summary_.last_error = event.text;
  in_flight_.lost_up_to(last_id_);
}

}  // namespace amalgam::client
