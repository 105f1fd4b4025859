#include "net/conversation.h"

#include <algorithm>
#include <utility>

#include "common/log.h"
#include "net/quietly.h"
#include "net/wire.h"
#include "protocol/limits.h"

namespace amalgam::net {

using protocol::Envelope;
using protocol::Error;

Conversation::Conversation(std::uint64_t id, std::string peer, Line& line, ServerContext& context)
    : id_(id),
      peer_(std::move(peer)),
      line_(line),
      context_(context),
      pose_hold_(context.config.session.pose_hold),
      own_light_(context.admission),
      environment_rate_(protocol::kEnvironmentBurst,
                        context.config.session.environments_per_second),
      ledger_(context.metrics),
      recording_(context.recorder) {}

// --- what the client says ---

void Conversation::visit(const Envelope& envelope) {
  recording_.received(envelope);
  const Envelope::BodyCase body = envelope.body_case();
  const bool may_come_first = body == Envelope::kHello || body == Envelope::BODY_NOT_SET;
  if (state_ == State::AwaitingHello && !may_come_first) {
    throw ClientError(Error::UNEXPECTED_MESSAGE, "a message before the hello");
  }
  switch (body) {
    case Envelope::kHello:
      return on_hello(envelope.hello());
    case Envelope::kCameraFrame:
      return on_camera_frame(envelope.camera_frame());
    case Envelope::kEnvironment:
      return on_environment(envelope.environment());
    case Envelope::kPing:
      return line_.send(pong_message(envelope.ping().nonce()));
    case Envelope::kPong:
      return line_.heard_pong(envelope.pong().nonce());
    case Envelope::kGoodbye:
      return line_.close();
    case Envelope::kWelcome:
    case Envelope::kComposite:
    case Envelope::kBusy:
    case Envelope::kError:
    case Envelope::kDraining:
      throw ClientError(Error::UNEXPECTED_MESSAGE, "a message that only servers send");
    case Envelope::BODY_NOT_SET:
      throw ClientError(Error::UNKNOWN_MESSAGE, "a message of no known kind");
  }
}

void Conversation::on_hello(const protocol::Hello& hello) {
  if (state_ != State::AwaitingHello) {
    throw ClientError(Error::UNEXPECTED_MESSAGE, "a second hello");
  }
  try {
    rights_ = check_admission(hello, context_.config.grants);
  } catch (const ClientError& error) {
    if (error.code == Error::AUTH_FAILED) line_.refused();
    throw;
  }
  const frame::ViewOptions options = view_options_from(hello);
  corner_poses_.emplace(hello, options.camera);
  if (const auto busy = context_.admission.admit(options.camera, context_.service.load())) {
    context_.metrics.refused(busy->label);
    common::log_info(common::LogKind::Refusal, name() + ": refused, " + busy->reason);
    return line_.send_last(busy_message(busy->retry_after, busy->reason));
  }
  camera_ = options.camera;
  state_ = State::Running;  // from here on leave() gives back what was taken
  view_ = context_.service.open_view(options, posting(&Conversation::on_rendered));
  context_.metrics.session_opened();
  const protocol::Fingerprint fingerprint = fingerprint_message(context_.service.fingerprint());
  recording_.begin(id_, hello, fingerprint);
  line_.send(
      welcome_message(id_, context_.config.session, context_.service.markers(), fingerprint));
  line_.welcomed();
  common::log_info(common::LogKind::Session, name() + ": " + std::to_string(camera_.width) + " x " +
                                                 std::to_string(camera_.height));
}

void Conversation::refuse_poses(std::uint64_t frame_id, std::size_t message_bytes) {
  if (state_ == State::AwaitingHello) {
    throw ClientError(Error::UNEXPECTED_MESSAGE, "a message before the hello");
  }
  ledger_.receive(message_bytes);
  recording_.received_refused_frame();
  figures_.received(Clock::now());
  if (state_ == State::Draining) return ledger_.skip(Skip::Draining);
  ledger_.skip(Skip::Refused);
  throw ClientError(
      Error::TOO_MANY_POSES,
      "more than the " + std::to_string(protocol::kMaxPoses) + " poses that are accepted",
      frame_id);
}

void Conversation::on_camera_frame(const protocol::CameraFrame& frame) {
  FrameLedger::Entry entry;
  entry.ticket = ledger_.receive(frame.ByteSizeLong());
  entry.frame_id = frame.frame_id();
  entry.arrival = Clock::now();
  figures_.received(entry.arrival);
  if (state_ == State::Draining) return ledger_.skip(Skip::Draining);
  const CaptureClock::Judged capture = capture_clock_.judge(frame.capture_time_us(), entry.arrival);
  if (capture.clamped) context_.metrics.capture_time_clamped();
  entry.capture_time_us = capture.time_us;
  entry.poses = usable_poses(frame, entry);

  recording_.submitted(entry.ticket, entry.poses);
  const bool replaced = context_.service.submit(
      *view_, entry.ticket, {.image = bytes_from(frame.jpeg()), .poses = entry.poses});
  ledger_.submit(std::move(entry), replaced);
}

std::vector<common::MarkerPose> Conversation::usable_poses(const protocol::CameraFrame& frame,
                                                           const FrameLedger::Entry& entry) {
  std::vector<common::MarkerPose> poses = poses_from(frame);
  std::vector<int> rejected;
  if (frame.corners_size() > 0) {
    CornerPoses::Solved solved = solve(frame, entry);
    poses.insert(poses.end(), solved.poses.begin(), solved.poses.end());
    rejected = std::move(solved.rejected);
  }
  PoseHold::Resolved resolved = pose_hold_.resolve(poses, entry.arrival);
  rejected.insert(rejected.end(), resolved.rejected.begin(), resolved.rejected.end());
  if (!rejected.empty()) {
    context_.metrics.pose_held_or_dropped(rejected.size());
    answer(poses_rejected(rejected, frame.frame_id()));
  }
  return std::move(resolved.poses);
}

CornerPoses::Solved Conversation::solve(const protocol::CameraFrame& frame,
                                        const FrameLedger::Entry& entry) {
  // A client without a clock leaves the capture time at 0. Times beyond what a clock can count
  // stand still, and poses stay raw.
  constexpr auto kLatest =
      std::chrono::floor<std::chrono::microseconds>(Clock::time_point::max().time_since_epoch());
  const auto time = std::min(entry.capture_time_us, static_cast<std::uint64_t>(kLatest.count()));
  const Clock::time_point captured = frame.capture_time_us() == 0
                                         ? entry.arrival
                                         : Clock::time_point(std::chrono::microseconds(time));
  return corner_poses_->solve(frame.corners(), context_.service.markers(), captured);
}

void Conversation::on_environment(const protocol::Environment& environment) {
  if (state_ == State::Draining) return;
  check_environment_right(environment.own());
  frame::EnvironmentInput input = environment_from(environment);
  if (environment.own()) input.only_for = view_;
  recording_.environment_accepted();
  EnvironmentSlot::Offered offered = environments_.offer(std::move(input));
  apply(std::move(offered.now));
  if (offered.replaced) {
    context_.metrics.environment(EnvironmentFate::Replaced);
    throw ClientError(Error::BAD_ENVIRONMENT, "replaced by a newer one before it was used");
  }
}

// Whoever may have a session may light it: an own environment changes nothing for anybody else.
void Conversation::check_environment_right(bool own) {
  const EnvironmentFrom from = context_.config.environment_from;
  const bool may =
      from == EnvironmentFrom::Any || (from == EnvironmentFrom::Authorised && rights_.environment);
  if (!own && !may) {
    context_.metrics.environment(EnvironmentFate::Forbidden);
    throw ClientError(Error::BAD_ENVIRONMENT, "this client may not change the light");
  }
  if (!environment_rate_.admit(Clock::now())) {
    context_.metrics.environment(EnvironmentFate::TooOften);
    throw ClientError(Error::BAD_ENVIRONMENT, "environments came too often");
  }
}

void Conversation::apply(std::optional<frame::EnvironmentInput> environment) {
  if (!environment) return;
  if (environment->only_for && !own_light_.begin(context_.service.memory_of(*environment))) {
    context_.metrics.environment(EnvironmentFate::NoMemory);
    answer(ClientError(Error::BAD_ENVIRONMENT, "no memory for this environment"));
    recording_.environment_done(false);
    return apply(environments_.done());
  }
  context_.service.set_environment(std::move(*environment),
                                   posting(&Conversation::on_environment_applied));
}

// --- what the renderer says ---

// What the renderer calls on its own thread becomes a step of the line's.
template <typename... Args>
std::function<void(Args...)> Conversation::posting(void (Conversation::*handler)(Args...)) {
  return [this, post = line_.posting(), handler](Args... args) {
    post([this, handler, ... args = std::move(args)]() mutable {
      (this->*handler)(std::move(args)...);
    });
  };
}

void Conversation::on_rendered(std::uint64_t ticket, frame::FrameResult result) {
  std::optional<FrameLedger::Entry> frame = ledger_.deliver(ticket);
  if (!frame) return;
  if (auto* output = std::get_if<frame::FrameOutput>(&result)) {
    return send_composite(std::move(*frame), std::move(*output));
  }
  ledger_.skip(Skip::Refused);
  const ClientError error = told_of(std::get<frame::FrameFailure>(result), frame->frame_id);
  recording_.failed(ticket, error_message(error).error());
  answer(error);
}

ClientError Conversation::told_of(const frame::FrameFailure& failure,
                                  std::uint64_t frame_id) const {
  switch (failure.kind) {
    case frame::FrameFailure::Kind::BadImage:
      return {Error::BAD_IMAGE, failure.what, frame_id};
    case frame::FrameFailure::Kind::Internal:
      // What went wrong inside is the operator's to read, not a stranger's.
      common::log_error(common::LogKind::Frame,
                        name() + ": frame " + std::to_string(frame_id) + ": " + failure.what);
      break;
  }
  return {Error::INTERNAL, "the frame could not be rendered", frame_id};
}

void Conversation::on_environment_applied(std::optional<std::string> error) {
  if (state_ == State::Over) return;
  own_light_.end(!error);
  recording_.environment_done(!error);
  context_.metrics.environment(error ? EnvironmentFate::Unusable : EnvironmentFate::Applied);
  if (error) answer(ClientError(Error::BAD_ENVIRONMENT, *error));
  apply(environments_.done());
}

void Conversation::send_composite(FrameLedger::Entry frame, frame::FrameOutput output) {
  const std::chrono::duration<double, std::milli> server_time = Clock::now() - frame.arrival;
  context_.metrics.frame_rendered(output, server_time.count());
  figures_.rendered(output, server_time.count());
  if (context_.config.admin_pictures) keep_picture(output.jpeg);
  Answer answer{std::move(frame), std::move(output), server_time.count()};
  recording_.rendered(answer.frame.ticket, [&] {
    return std::move(*composite_message(answer, skipped()).mutable_composite());
  });
  if (line_.send_answer(std::move(answer))) ledger_.skip(Skip::ReplacedBeforeWrite);
}

void Conversation::writing(const Envelope& ping) {
  recording_.written();
  recording_.sent(ping);
}

void Conversation::not_said() const {
  common::log_debug(name() + ": an answer was dropped");
}

// A copy: the composite itself becomes part of a message. A picture to look at is worth no session.
void Conversation::keep_picture(const frame::Bytes& jpeg) {
  picture_.reset();
  quietly([&] { picture_ = std::make_shared<const frame::Bytes>(jpeg); });
}

void Conversation::written(std::size_t message_bytes) {
  ledger_.sent(message_bytes);
  figures_.sent(Clock::now());
}

// --- errors and ends ---

void Conversation::answer(const ClientError& error) {
  const bool closes = !is_survivable(error.code);
  context_.metrics.error_sent(error.code);
  const std::string line = name() + ": " + Error::Code_Name(error.code) + ": " + error.what();
  closes ? common::log_info(common::LogKind::Refusal, line) : common::log_debug(line);
  closes ? line_.send_last(error_message(error)) : line_.send(error_message(error));
}

void Conversation::drain(std::chrono::milliseconds deadline) {
  if (state_ != State::AwaitingHello && state_ != State::Running) return;
  line_.send(draining_message(deadline));
  if (state_ == State::AwaitingHello) return line_.close();
  state_ = State::Draining;
}

void Conversation::leave() {
  const State before = std::exchange(state_, State::Over);
  forget_picture();
  recording_.end(record::Fate::Closed);
  if (before == State::Running || before == State::Draining) context_.admission.leave(camera_);
  if (!view_) return;
  context_.service.close_view(*std::exchange(view_, std::nullopt));
  own_light_.leave();
  context_.metrics.session_closed();
  ledger_.abandon();
}

std::string Conversation::name() const {
  return "session " + std::to_string(id_) + " (" + peer_ + ")";
}

SessionReport Conversation::report() const {
  constexpr const char* kNames[] = {"awaiting_hello", "running", "draining", "closing"};
  SessionReport report;
  report.id = id_;
  report.peer = peer_;
  report.state = kNames[static_cast<int>(state_)];
  const auto now = Clock::now();
  report.age = std::chrono::duration_cast<std::chrono::seconds>(now - begun_);
  report.width = camera_.width;
  report.height = camera_.height;
  report.received = ledger_.received_count();
  report.sent = ledger_.sent_count();
  report.skipped = ledger_.skipped_count();
  report.in_flight = ledger_.in_flight();
  for (const Skip reason : kSkips) {
    report.skipped_by[static_cast<std::size_t>(reason)] = ledger_.skipped_count(reason);
  }
  report.bytes_received = ledger_.bytes_received();
  report.bytes_sent = ledger_.bytes_sent();
  figures_.fill(report, now);
  report.own_environment = own_light_.exists();
  report.record = record::to_string(recording_.fate());
  report.record_bytes = recording_.bytes();
  report.picture = picture_ != nullptr;
  return report;
}

}  // namespace amalgam::net
