#include "net/session.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "common/log.h"
#include "common/tcp_options.h"
#include "net/wire.h"
#include "protocol/geometry.h"
#include "protocol/limits.h"

namespace amalgam::net {

namespace asio = boost::asio;
using protocol::Envelope;
using protocol::Error;

namespace {

// Address and port of the other end, for logs.
std::string peer_of(const asio::ip::tcp::socket& socket) {
  boost::system::error_code ec;
  const auto endpoint = socket.remote_endpoint(ec);
  return ec ? "unknown"
            : to_string(common::HostPort{endpoint.address().to_string(), endpoint.port()});
}

}  // namespace

Session::Session(asio::ip::tcp::socket socket, ConnectionLimits::Ticket ticket, std::uint64_t id,
                 SessionContext& context)
    : socket_(std::move(socket)),
      timer_(socket_.get_executor()),
      ticket_(std::move(ticket)),
      id_(id),
      peer_(peer_of(socket_)),
      context_(context),
      deadlines_(context.config.session, Clock::now()),
      read_buffer_(protocol::kMaxBeforeHelloBytes),
      decoder_(protocol::limits_before_hello()),
      slot_(protocol::kMaxQueuedControl),
      pose_hold_(context.config.session.pose_hold),
      ledger_(context.metrics) {}

Session::~Session() {
  leave_renderer();
}

void Session::start() {
  common::set_tcp_options(socket_.native_handle(),
                          {context_.config.session.idle_timeout, protocol::kUnsentBytes});
  wait();
  read();
}

// --- reading ---

void Session::read() {
  socket_.async_read_some(asio::buffer(read_buffer_),
                          [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                            self->guarded([&] { self->on_read(ec, size); });
                          });
}

void Session::on_read(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "read");
  // While closing, what still arrives is thrown away: unread bytes would make the kernel reset the
  // connection, and the client would never see the Error that tells it why.
  if (is_open()) take(std::span(read_buffer_).first(size));
  if (state_ != State::Ended) read();
}

void Session::take(std::span<const std::byte> input) {
  while (is_open()) {
    const protocol::Decoder::Result result = decoder_.next(input);
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) break;
    if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
      return fail(Error::PROTOCOL_ERROR, failure->what);
    }
    deadlines_.received_message(Clock::now());
    guarded([&] { visit(std::get<Envelope>(result)); });
  }
  deadlines_.received_part(decoder_.bytes_of_unfinished(), Clock::now());
}

// --- what the client says ---

void Session::visit(const Envelope& envelope) {
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
      return on_ping(envelope.ping());
    case Envelope::kPong:
      return;  // being heard is all that it is for
    case Envelope::kGoodbye:
      return close(context_.config.session.linger);
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

void Session::on_hello(const protocol::Hello& hello) {
  if (state_ != State::AwaitingHello) {
    throw ClientError(Error::UNEXPECTED_MESSAGE, "a second hello");
  }
  check_admission(hello, context_.config.token);
  const frame::ViewOptions options = view_options_from(hello);
  view_ = context_.service.open_view(options, posting(&Session::on_rendered));
  camera_ = options.camera;
  state_ = State::Running;
  ticket_->authenticated();
  context_.metrics.session_opened();
  decoder_.set_limits(protocol::limits_of_server());
  deadlines_.authenticated(Clock::now());
  wait();
  send(welcome_message(id_, context_.config.session, context_.service.markers()));
  common::log_info(name() + ": " + std::to_string(camera_.width) + " x " +
                   std::to_string(camera_.height));
}

void Session::on_camera_frame(const protocol::CameraFrame& frame) {
  FrameLedger::Entry entry;
  entry.number = ledger_.receive(frame.ByteSizeLong());
  entry.frame_id = frame.frame_id();
  entry.arrival = Clock::now();
  if (state_ == State::Draining) return ledger_.skip(Skip::Draining);
  if (frame.poses_size() > protocol::kMaxPoses) {
    ledger_.skip(Skip::Refused);
    throw ClientError(Error::TOO_MANY_POSES,
                      std::to_string(frame.poses_size()) + " poses; at most " +
                          std::to_string(protocol::kMaxPoses) + " are accepted",
                      frame.frame_id());
  }
  const CaptureClock::Judged capture = capture_clock_.judge(frame.capture_time_us(), entry.arrival);
  if (capture.clamped) context_.metrics.capture_time_clamped();
  entry.capture_time_us = capture.time_us;
  entry.poses = usable_poses(frame);

  const bool replaced = context_.service.submit(
      *view_, entry.number, {.image = bytes_from(frame.jpeg()), .poses = entry.poses});
  ledger_.submit(std::move(entry), replaced);
}

std::vector<common::MarkerPose> Session::usable_poses(const protocol::CameraFrame& frame) {
  PoseHold::Resolved resolved = pose_hold_.resolve(poses_from(frame), Clock::now());
  if (!resolved.rejected.empty()) {
    context_.metrics.pose_held_or_dropped(resolved.rejected.size());
    answer(poses_rejected(resolved.rejected, frame.frame_id()));
  }
  return std::move(resolved.poses);
}

void Session::on_environment(const protocol::Environment& environment) {
  if (state_ == State::Draining) return;
  EnvironmentSlot::Offered offered = environments_.offer(environment_from(environment));
  apply(std::move(offered.now));
  if (offered.replaced) {
    throw ClientError(Error::BAD_ENVIRONMENT, "replaced by a newer one before it was used");
  }
}

void Session::apply(std::optional<frame::EnvironmentInput> environment) {
  if (!environment) return;
  context_.service.set_environment(std::move(*environment),
                                   posting(&Session::on_environment_applied));
}

void Session::on_ping(const protocol::Ping& ping) {
  send(pong_message(ping.nonce()));
}

// --- what the renderer says ---

// What the renderer calls on its own thread becomes a call on the network's, if the session still
// lives by then.
template <typename... Args>
std::function<void(Args...)> Session::posting(void (Session::*handler)(Args...)) {
  return [executor = socket_.get_executor(), weak = weak_from_this(), handler](Args... args) {
    asio::post(executor, [weak, handler, ... args = std::move(args)]() mutable {
      const auto self = weak.lock();
      if (self) self->guarded([&] { ((*self).*handler)(std::move(args)...); });
    });
  };
}

void Session::on_rendered(std::uint64_t number, frame::FrameResult result) {
  const std::optional<FrameLedger::Entry> frame = ledger_.deliver(number);
  if (!frame) return;
  if (const auto* output = std::get_if<frame::FrameOutput>(&result)) {
    send_composite(*frame, *output);
    return close_if_drained();
  }
  ledger_.skip(Skip::Refused);
  const auto& failure = std::get<frame::FrameFailure>(result);
  switch (failure.kind) {
    case frame::FrameFailure::Kind::BadImage:
      answer(ClientError(Error::BAD_IMAGE, failure.what, frame->frame_id));
      return close_if_drained();
    case frame::FrameFailure::Kind::Internal:
      // What went wrong inside is the operator's to read, not a stranger's.
      common::log_error(name() + ": frame " + std::to_string(frame->frame_id) + ": " +
                        failure.what);
      return answer(
          ClientError(Error::INTERNAL, "the frame could not be rendered", frame->frame_id));
  }
}

void Session::on_environment_applied(std::optional<std::string> error) {
  if (!is_open()) return;
  if (error) answer(ClientError(Error::BAD_ENVIRONMENT, *error));
  apply(environments_.done());
}

void Session::send_composite(const FrameLedger::Entry& frame, const frame::FrameOutput& output) {
  const std::chrono::duration<double, std::milli> server_time = Clock::now() - frame.arrival;
  context_.metrics.frame_rendered(output, server_time.count());
  protocol::Composite composite = composite_from(output);
  composite.set_frame_id(frame.frame_id);
  composite.set_capture_time_us(frame.capture_time_us);
  composite.set_server_ms(server_time.count());
  for (const common::MarkerPose& pose : frame.poses)
    *composite.add_poses() = protocol::to_message(pose);
  if (slot_.put_composite(std::move(composite))) ledger_.skip(Skip::ReplacedBeforeWrite);
  write();
}

// --- writing ---

void Session::send(const Envelope& message) {
  // A peer that does not read its answers loses some; the write time-out ends it if that goes on.
  if (!slot_.put_control(message)) common::log_debug(name() + ": an answer was dropped");
  write();
}

void Session::write() {
  std::optional<std::string> bytes = slot_.begin_write(ledger_.skipped_count());
  if (!bytes) return;
  writing_ = std::move(*bytes);
  deadlines_.write_begun(Clock::now());
  asio::async_write(socket_, asio::buffer(writing_),
                    [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                      self->guarded([&] { self->on_written(ec, size); });
                    });
}

void Session::on_written(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "write");
  if (slot_.writing_composite()) ledger_.sent(size);
  slot_.end_write();
  deadlines_.write_ended();
  write();
  if (state_ == State::Closing) finish_sending();
  close_if_drained();
}

// --- time ---

void Session::wait() {
  // Setting a new time cancels the wait that is under way.
  timer_.expires_at(state_ == State::Closing ? linger_end_ : deadlines_.next());
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    self->guarded([&] { self->on_time(ec); });
  });
}

void Session::on_time(const ErrorCode& ec) {
  if (ec || state_ == State::Ended) return;
  const Clock::time_point now = Clock::now();
  if (state_ == State::Closing) {
    if (now >= linger_end_) return end();
    return wait();
  }
  if (const auto passed = deadlines_.passed(now)) return on_passed(*passed);
  if (deadlines_.ping_due(now)) send(ping_message(++pings_));
  wait();
}

void Session::on_passed(Deadlines::Passed passed) {
  switch (passed) {
    case Deadlines::Passed::Hello:
      return fail(Error::AUTH_TIMEOUT, "no complete hello in time");
    case Deadlines::Passed::SlowSender:
      return fail(Error::SLOW_SENDER, "a message came too slowly");
    case Deadlines::Passed::SlowReader:
      // Nothing can be said to somebody who does not read.
      context_.metrics.error_sent(Error::SLOW_READER);
      common::log_info(name() + ": evicted, it does not read");
      return end();
    case Deadlines::Passed::Idle:
      fail(Error::IDLE_TIMEOUT, "nothing was heard, not even a pong");
      // Its error is on the way or will never be; a peer that is gone need not be waited for.
      return end();
  }
}

// --- errors and ends ---

// The one place where what is thrown in a session is caught: bad input is answered, anything else
// ends this session and no other.
template <typename Step>
void Session::guarded(Step step) {
  try {
    step();
  } catch (const ClientError& error) {
    answer(error);
  } catch (const std::exception& error) {
    common::log_error(name() + ": " + error.what());
    end();
  }
}

void Session::answer(const ClientError& error) {
  const bool closes = !is_survivable(error.code);
  context_.metrics.error_sent(error.code);
  const std::string line = name() + ": " + Error::Code_Name(error.code) + ": " + error.what();
  closes ? common::log_info(line) : common::log_debug(line);
  if (closes) slot_.drop_control();
  send(error_message(error));
  if (closes) close(context_.config.session.linger);
}

void Session::lost(const ErrorCode& ec, const char* what) {
  if (state_ != State::Closing) common::log_info(name() + ": " + what + ": " + ec.message());
  end();
}

}  // namespace amalgam::net
