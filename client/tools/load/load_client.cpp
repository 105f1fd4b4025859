#include "client/tools/load/load_client.h"

#include <boost/asio/ip/address_v4.hpp>
#include <boost/asio/post.hpp>
#include <limits>
#include <random>
#include <span>
#include <utility>

#include "client/link/messages.h"
#include "client/tools/load/silent_client.h"
#include "protocol/framing.h"

namespace amalgam::load {
namespace {

namespace asio = boost::asio;
using protocol::Envelope;

// Time for answers after the last frame, and for a welcome, even from a slow machine.
constexpr std::chrono::seconds kPatience{20};
constexpr double kMarkerDistance = 0.4;  // metres, straight ahead

std::uint64_t microseconds(std::chrono::steady_clock::time_point time) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch()).count());
}

}  // namespace

LoadClient::LoadClient(asio::io_context& io, const LoadOptions& options, const LoadImage& image,
                       LoadSummary& summary, int number)
    : io_(io), options_(options), image_(image), summary_(summary), number_(number), timer_(io) {}

void LoadClient::start(Clock::time_point load_begin) {
  load_begin_ = load_begin;
  if (options_.fault == Fault::HalfOpen) {
    return std::make_shared<SilentClient>(io_, options_, summary_)->start(source_address());
  }
  link_ = std::make_shared<client::Link>(io_, options_.tls, events());
  if (const auto source = source_address()) link_->come_from(*source);
  link_->open(options_.server, hello(), kPatience);
}

client::Link::Events LoadClient::events() {
  client::Link::Events events;
  events.welcomed = [self = shared_from_this()](const protocol::Welcome& welcome) {
    self->on_welcome(welcome);
  };
  events.composite = [self = shared_from_this()](const protocol::Composite& composite) {
    self->on_composite(composite);
  };
  events.error = [self = shared_from_this()](const protocol::Error& error) {
    self->on_error(error);
  };
  events.idle = [self = shared_from_this()] { self->on_idle(); };
  events.ended = [self = shared_from_this()](const client::LinkEnd& end) {
    self->on_link_end(end);
  };
  events.draining = [self = shared_from_this()] {
    self->draining_ = true;
    if (self->state_ != State::Ended) self->wait_for_answers();
  };
  return events;
}

std::optional<asio::ip::address> LoadClient::source_address() const {
  if (options_.sources == 0) return std::nullopt;
  // All of 127.0.0.0/8 is this machine.
  constexpr unsigned kLoopback = 0x7f000000;
  return asio::ip::address_v4(
      kLoopback + static_cast<unsigned>(options_.first_source + number_ % options_.sources));
}

protocol::Hello LoadClient::hello() const {
  const common::CameraModel camera{.width = image_.width,
                                   .height = image_.height,
                                   .fx = static_cast<double>(image_.width),
                                   .fy = static_cast<double>(image_.width),
                                   .cx = (image_.width - 1) / 2.0,
                                   .cy = (image_.height - 1) / 2.0};
  const bool wrong = options_.fault == Fault::WrongToken;
  return client::hello_message(camera, wrong ? "not " + options_.token : options_.token, 0);
}

// --- what comes back ---

void LoadClient::on_welcome(const protocol::Welcome& welcome) {
  ++summary_.welcomed;
  marker_ = welcome.markers().world_marker();
  if (options_.fault == Fault::HelloOnly) return end(false);
  if (options_.fault == Fault::SlowReader) link_->stop_reading();
  state_ = State::Sending;
  begin_ = next_frame_ = Clock::now();
  options_.fault == Fault::Garbage ? send_garbage() : send_frame();
}

void LoadClient::on_composite(const protocol::Composite& composite) {
  if (state_ == State::Ended) return;
  ++summary_.composited;
  if (composite.unchanged()) ++summary_.unchanged;
  summary_.skipped += composite.skipped() - skipped_;
  skipped_ = composite.skipped();
  const Clock::time_point now = Clock::now();
  const std::uint64_t age = microseconds(now) - composite.capture_time_us();
  summary_.latencies_ms.push_back(static_cast<double>(age) / 1000.0);
  for (; !due_.empty() && due_.front().answered_by <= composite.frame_id(); due_.pop_front()) {
    const Clock::time_point due = due_.front().due;
    summary_.due.push_back({std::chrono::duration<double>(due - load_begin_).count(),
                            std::chrono::duration<double, std::milli>(now - due).count()});
  }
  answered(composite.frame_id());
}

void LoadClient::on_error(const protocol::Error& error) {
  if (state_ == State::Ended) return;
  ++summary_.errors[protocol::Error::Code_Name(error.code())];
  // A frame with rejected poses still gets its composite.
  if (error.code() != protocol::Error::POSE_REJECTED) answered(error.frame_id());
}

void LoadClient::on_link_end(const client::LinkEnd& link_end) {
  if (state_ != State::Ended) {
    const bool busy = link_end.kind == client::LinkEnd::Kind::Busy;
    if (busy) ++summary_.errors["BUSY"];
    if (link_end.code) ++summary_.errors[protocol::Error::Code_Name(*link_end.code)];
    end(busy || link_end.code || !draining_);
  }
  summary_.bytes_sent += link_->bytes_sent();
  summary_.bytes_received += link_->bytes_received();
  // The link is in the middle of telling this, and holds this client.
  asio::post(io_, [link = std::move(link_)] {});
}

void LoadClient::answered(std::uint64_t frame_id) {
  if (state_ == State::Waiting && frame_id == last_frame_) end(false);
}

// --- what is sent ---

void LoadClient::wait_for_next_frame() {
  next_frame_ += std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / options_.rate));
  const bool enough =
      options_.frames > 0 ? last_frame_ >= options_.frames : next_frame_ - begin_ >= length();
  if (enough) {
    if (options_.fault != Fault::Cut) return wait_for_answers();
    state_ = State::Cutting;
    return on_idle();
  }
  timer_.expires_at(next_frame_);
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec && self->state_ == State::Sending) self->send_frame();
  });
}

void LoadClient::send_frame() {
  due_.push_back({last_frame_ + 1, next_frame_});
  if (!waiting_.empty()) {
    ++summary_.unsent;
  } else {
    if (options_.fault == Fault::Environments) send_environment();
    ++summary_.sent;
    waiting_ = protocol::encode(next_frame());
    on_idle();
  }
  if (state_ == State::Sending) wait_for_next_frame();
}

// The link may be writing something still.
void LoadClient::on_idle() {
  if (!link_ || !link_->is_idle()) return;
  if (!waiting_.empty()) return link_->write_frame(std::exchange(waiting_, ""));
  if (state_ != State::Cutting) return;
  if (std::exchange(half_sent_, true)) return end(false);
  const std::string last = protocol::encode(next_frame());
  link_->write_first(last.substr(0, last.size() / 2));
}

std::chrono::milliseconds LoadClient::length() const {
  return options_.arrivals > 0.0 && options_.stay.count() > 0 ? options_.stay : options_.duration;
}

void LoadClient::send_environment() {
  Envelope envelope;
  envelope.mutable_environment()->set_image(image_.jpeg);
  envelope.mutable_environment()->set_own(last_frame_ % 2 == 0);
  link_->write_first(protocol::encode(envelope));
}

// Different for each client, and the same whenever that client is run again.
void LoadClient::send_garbage() {
  std::mt19937 random(static_cast<unsigned>(number_));
  std::string bytes(1 + random() % (16 * 1024), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() % 256);
  link_->write_first(std::move(bytes));
  wait_for_answers();
}

double LoadClient::marker_distance() const {
  if (!options_.moving) return kMarkerDistance;
  // A millimetre a frame, up to a tenth away and back at once.
  return kMarkerDistance * (1.0 + 0.0025 * static_cast<double>(last_frame_ % 40));
}

Envelope LoadClient::next_frame() {
  const std::string jpeg = options_.fault == Fault::BadImage ? "not a JPEG" : image_.jpeg;
  const double distance = options_.fault == Fault::BadPose
                              ? std::numeric_limits<double>::quiet_NaN()
                              : marker_distance();
  const common::MarkerPose pose{.marker = marker_,
                                .rotation = {0.0, 1.0, 0.0, 0.0},  // it faces the camera
                                .translation = {0.0, 0.0, distance}};
  const std::span bytes(reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
  return client::frame_message(++last_frame_, bytes, next_frame_, std::span(&pose, 1));
}

void LoadClient::wait_for_answers() {
  state_ = State::Waiting;
  const bool answers = options_.fault != Fault::SlowReader;
  timer_.expires_after(answers ? kPatience : std::chrono::seconds(0));
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec && self->state_ == State::Waiting) self->end(false);
  });
}

void LoadClient::end(bool lost) {
  if (state_ == State::Ended) return;
  state_ = State::Ended;
  if (lost) ++summary_.lost;
  summary_.unanswered += due_.size();
  timer_.cancel();
  // Only who behaves says goodbye.
  options_.fault == Fault::None ? link_->close() : link_->cut();
}

}  // namespace amalgam::load
