#include "client/tools/load/replay.h"

#include <utility>

#include "protocol/framing.h"

namespace amalgam::load {

using protocol::Envelope;

Replay::Replay(boost::asio::io_context& io, const LoadOptions& options,
               const RecordedSession& session, ReplayComparison& comparison)
    : options_(options), session_(session), comparison_(comparison), timer_(io) {
  client::Link::Events events;
  events.welcomed = [this](const protocol::Welcome& welcome) {
    comparison_.welcomed(welcome);
    begin();
  };
  events.composite = [this](const protocol::Composite& composite) {
    if (over_) return;
    comparison_.answered(composite.frame_id(), composite);
    answered(composite.frame_id());
  };
  events.error = [this](const protocol::Error& error) { on_error(error); };
  events.idle = [this] { write_next(); };
  events.ended = [this](const client::LinkEnd& end) { on_end(end); };
  link_ = std::make_shared<client::Link>(io, options.tls, std::move(events));
}

void Replay::start() {
  protocol::Hello hello = session_.header.hello();
  hello.set_token(options_.token);
  link_->open(options_.server, hello, kPatience);
}

void Replay::on_error(const protocol::Error& error) {
  if (over_) return;
  // A frame with rejected poses still gets its composite.
  if (error.code() == protocol::Error::POSE_REJECTED) return;
  if (error.frame_id() == 0) {
    return comparison_.remark(protocol::Error::Code_Name(error.code()) + ": " + error.text());
  }
  comparison_.refused(error.frame_id(), error);
  answered(error.frame_id());
}

void Replay::on_end(const client::LinkEnd& end) {
  if (!over_) comparison_.remark("the session ended early: " + end.text);
  over_ = true;
  timer_.cancel();
}

void Replay::send(std::uint64_t number, protocol::CameraFrame frame) {
  Envelope envelope;
  frame.set_frame_id(number);
  *envelope.mutable_camera_frame() = std::move(frame);
  put(protocol::encode(envelope));
}

void Replay::send(const RecordedLight& light) {
  Envelope envelope;
  *envelope.mutable_environment() = light.environment;
  put(protocol::encode(envelope));
}

void Replay::put(std::string bytes) {
  waiting_.push_back(std::move(bytes));
  write_next();
}

void Replay::write_next() {
  if (waiting_.empty() || !link_->is_idle()) return;
  std::string bytes = std::move(waiting_.front());
  waiting_.pop_front();
  link_->write_frame(std::move(bytes));
}

void Replay::wait_until(Clock::time_point time, std::function<void()> then) {
  timer_.expires_at(time);
  timer_.async_wait([this, then = std::move(then)](const boost::system::error_code& ec) {
    if (!ec && !over_) then();
  });
}

void Replay::finish() {
  over_ = true;
  timer_.cancel();
  link_->close();
}

}  // namespace amalgam::load
