#include "client/tools/load/load_client.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/address.hpp>
#include <limits>
#include <random>
#include <span>

#include "protocol/limits.h"

namespace amalgam::load {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using protocol::Envelope;

// Time for answers after the last frame, even from a slow machine.
constexpr std::chrono::seconds kPatience{20};
constexpr double kMarkerDistance = 0.4;  // metres, straight ahead
// Frames that may wait behind the one being written: none. This allows for small messages.
constexpr std::size_t kMaxQueue = 2;

std::uint64_t microseconds(std::chrono::steady_clock::time_point time) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch()).count());
}

}  // namespace

LoadClient::LoadClient(asio::io_context& io, const LoadOptions& options, const LoadImage& image,
                       LoadSummary& summary, int number)
    : options_(options),
      image_(image),
      summary_(summary),
      number_(number),
      stream_(tcp::socket(io)),
      timer_(io),
      buffer_(protocol::kReadBufferBytes) {}

void LoadClient::start(Clock::time_point load_begin) {
  load_begin_ = load_begin;
  const tcp::endpoint server(asio::ip::make_address(options_.server.host), options_.server.port);
  take_source_address();
  stream_.socket().async_connect(server, [self = shared_from_this()](const ErrorCode& ec) {
    if (ec) return self->end(true);
    ErrorCode ignored;
    self->stream_.socket().set_option(tcp::no_delay(true), ignored);
    if (self->options_.fault == Fault::HalfOpen) return self->say_nothing();
    self->options_.tls ? self->secure() : self->say_hello();
  });
}

void LoadClient::secure() {
  stream_.handshake_as_client(options_.tls, options_.server.host,
                              [self = shared_from_this()](const ErrorCode& ec) {
                                ec ? self->end(true) : self->say_hello();
                              });
}

void LoadClient::take_source_address() {
  if (options_.sources == 0) return;
  // All of 127.0.0.0/8 is this machine.
  constexpr unsigned kLoopback = 0x7f000000;
  const asio::ip::address_v4 address(
      kLoopback + static_cast<unsigned>(options_.first_source + number_ % options_.sources));
  stream_.socket().open(tcp::v4());
  stream_.socket().bind({address, 0});
}

void LoadClient::say_hello() {
  Envelope envelope;
  protocol::Hello& hello = *envelope.mutable_hello();
  hello.set_version(protocol::kProtocolVersion);
  hello.set_token(options_.fault == Fault::WrongToken ? "not " + options_.token : options_.token);
  protocol::Camera& camera = *hello.mutable_camera();
  camera.set_width(static_cast<std::uint32_t>(image_.width));
  camera.set_height(static_cast<std::uint32_t>(image_.height));
  camera.set_fx(image_.width);
  camera.set_fy(image_.width);
  camera.set_cx((image_.width - 1) / 2.0);
  camera.set_cy((image_.height - 1) / 2.0);
  send(envelope);
  read();
}

// --- what comes back ---

void LoadClient::read() {
  stream_.read_some(
      asio::buffer(buffer_), [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
        if (self->state_ == State::Ended) return;
        if (ec) return self->end(!self->draining_);
        self->take(size);
        const bool reads = self->options_.fault != Fault::SlowReader || self->marker_ == 0;
        if (self->state_ != State::Ended && reads) self->read();
      });
}

void LoadClient::take(std::size_t size) {
  summary_.bytes_received += size;
  std::span<const std::byte> input = std::span(buffer_).first(size);
  while (state_ != State::Ended) {
    const auto result = decoder_.next(input);
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) return;
    if (std::holds_alternative<protocol::Decoder::Failure>(result)) return end(true);
    visit(std::get<Envelope>(result));
  }
}

void LoadClient::visit(const Envelope& envelope) {
  switch (envelope.body_case()) {
    case Envelope::kWelcome:
      ++summary_.welcomed;
      marker_ = envelope.welcome().markers().world_marker();
      if (options_.fault == Fault::HelloOnly) return end(false);
      state_ = State::Sending;
      begin_ = next_frame_ = Clock::now();
      return options_.fault == Fault::Garbage ? send_garbage() : send_frame();
    case Envelope::kComposite:
      return on_composite(envelope.composite());
    case Envelope::kError:
      return on_error(envelope.error());
    case Envelope::kPing: {
      Envelope pong;
      pong.mutable_pong()->set_nonce(envelope.ping().nonce());
      return send(pong);
    }
    case Envelope::kBusy:
      ++summary_.errors["BUSY"];
      return end(true);
    case Envelope::kDraining:  // the server closes when it is done
      draining_ = true;
      return wait_for_answers();
    case Envelope::kPong:
      return;
    case Envelope::kHello:
    case Envelope::kCameraFrame:
    case Envelope::kEnvironment:
    case Envelope::kGoodbye:
    case Envelope::BODY_NOT_SET:
      return end(true);  // nothing that a server says
  }
}

void LoadClient::on_composite(const protocol::Composite& composite) {
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
  ++summary_.errors[protocol::Error::Code_Name(error.code())];
  if (error.closes()) return end(true);
  // A frame with rejected poses still gets its composite.
  if (error.code() != protocol::Error::POSE_REJECTED) answered(error.frame_id());
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
  if (enough) return options_.fault == Fault::Cut ? cut() : wait_for_answers();
  timer_.expires_at(next_frame_);
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec && self->state_ == State::Sending) self->send_frame();
  });
}

void LoadClient::send_frame() {
  due_.push_back({last_frame_ + 1, next_frame_});
  if (queue_.size() >= kMaxQueue) {
    ++summary_.unsent;
  } else {
    if (options_.fault == Fault::Environments) send_environment();
    ++summary_.sent;
    send(next_frame());
  }
  wait_for_next_frame();
}

std::chrono::milliseconds LoadClient::length() const {
  return options_.arrivals > 0.0 && options_.stay.count() > 0 ? options_.stay : options_.duration;
}

void LoadClient::send_environment() {
  Envelope envelope;
  envelope.mutable_environment()->set_image(image_.jpeg);
  envelope.mutable_environment()->set_own(last_frame_ % 2 == 0);
  send(envelope);
}

// Different for each client, and the same whenever that client is run again.
void LoadClient::send_garbage() {
  std::mt19937 random(static_cast<unsigned>(number_));
  std::string bytes(1 + random() % (16 * 1024), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() % 256);
  queue_.push_back(std::move(bytes));
  if (queue_.size() == 1) write();
  wait_for_answers();
}

void LoadClient::say_nothing() {
  read();
  wait_for_answers();
}

double LoadClient::marker_distance() const {
  if (!options_.moving) return kMarkerDistance;
  // A millimetre a frame, up to a tenth away and back at once.
  return kMarkerDistance * (1.0 + 0.0025 * static_cast<double>(last_frame_ % 40));
}

Envelope LoadClient::next_frame() {
  Envelope envelope;
  protocol::CameraFrame& frame = *envelope.mutable_camera_frame();
  frame.set_frame_id(++last_frame_);
  frame.set_capture_time_us(microseconds(next_frame_));
  frame.set_jpeg(options_.fault == Fault::BadImage ? "not a JPEG" : image_.jpeg);
  protocol::Pose& pose = *frame.add_poses();
  pose.set_marker(marker_);
  pose.mutable_rotation()->set_x(1.0);  // half a turn: the marker faces the camera
  pose.mutable_translation()->set_z(options_.fault == Fault::BadPose
                                        ? std::numeric_limits<double>::quiet_NaN()
                                        : marker_distance());
  return envelope;
}

void LoadClient::wait_for_answers() {
  state_ = State::Waiting;
  const bool answers = options_.fault != Fault::SlowReader;
  timer_.expires_after(answers ? kPatience : std::chrono::seconds(0));
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec && self->state_ == State::Waiting) self->end(false);
  });
}

void LoadClient::cut() {
  const auto bytes = std::make_shared<std::string>(protocol::encode(next_frame()));
  bytes->resize(bytes->size() / 2);
  stream_.write(asio::buffer(*bytes), [self = shared_from_this(), bytes](
                                          const ErrorCode&, std::size_t) { self->end(false); });
}

void LoadClient::send(const Envelope& envelope) {
  queue_.push_back(protocol::encode(envelope));
  if (queue_.size() == 1) write();
}

void LoadClient::write() {
  stream_.write(asio::buffer(queue_.front()),
                [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                  if (self->state_ == State::Ended) return;
                  if (ec) return self->end(!self->draining_);
                  self->summary_.bytes_sent += size;
                  self->queue_.pop_front();
                  if (!self->queue_.empty()) self->write();
                });
}

void LoadClient::end(bool lost) {
  if (state_ == State::Ended) return;
  state_ = State::Ended;
  if (lost) ++summary_.lost;
  summary_.unanswered += due_.size();
  stream_.close();
  timer_.cancel();
}

}  // namespace amalgam::load
