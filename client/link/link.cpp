#include "client/link/link.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ssl/error.hpp>
#include <utility>

#include "common/tcp_options.h"
#include "protocol/limits.h"

namespace amalgam::client {
namespace {

namespace asio = boost::asio;
using protocol::Envelope;
using protocol::Error;

// Errors that another attempt with the same hello would get again.
bool is_final(Error::Code code) {
  switch (code) {
    case Error::AUTH_TIMEOUT:
    case Error::SLOW_SENDER:
    case Error::SLOW_READER:
    case Error::IDLE_TIMEOUT:
    case Error::INTERNAL:
      return false;
    default:
      return true;
  }
}

}  // namespace

Link::Link(asio::io_context& io, protocol::Stream::Tls tls, Events events)
    : resolver_(io),
      tls_(std::move(tls)),
      stream_(asio::ip::tcp::socket(io)),
      timer_(io),
      events_(std::move(events)),
      read_buffer_(protocol::kReadBufferBytes),
      decoder_(protocol::limits_of_client()) {}

void Link::open(const common::HostPort& server, const protocol::Hello& hello,
                std::chrono::milliseconds timeout) {
  Envelope envelope;
  *envelope.mutable_hello() = hello;
  hello_ = protocol::encode(envelope);
  host_ = server.host;
  expect_within(timeout, "no connection in time");
  resolver_.async_resolve(server.host, std::to_string(server.port),
                          [self = shared_from_this()](const ErrorCode& ec, const auto& endpoints) {
                            if (ec) return self->fail(ec, "the address cannot be resolved");
                            self->connect(endpoints);
                          });
}

void Link::connect(const asio::ip::tcp::resolver::results_type& endpoints) {
  if (state_ != State::Connecting) return;
  auto done = [self = shared_from_this()](const ErrorCode& ec, const auto&...) {
    self->on_connected(ec);
  };
  if (!source_) return asio::async_connect(stream_.socket(), endpoints, std::move(done));
  // Trying one endpoint after the other would open the socket anew, and forget its address.
  if (bind_source()) stream_.socket().async_connect(*endpoints.begin(), std::move(done));
}

bool Link::bind_source() {
  const asio::ip::tcp::endpoint local(*source_, 0);
  ErrorCode ec;
  stream_.socket().open(local.protocol(), ec);
  if (!ec) stream_.socket().bind(local, ec);
  if (ec) fail(ec, "connect");
  return !ec;
}

void Link::on_connected(const ErrorCode& ec) {
  if (ec) return fail(ec, "connect");
  if (state_ != State::Connecting) return;
  common::set_tcp_options(
      stream_.socket().native_handle(),
      {.user_timeout = protocol::kIdleTimeout, .unsent_bytes = protocol::kUnsentBytes});
  tls_ ? secure() : say_hello();
}

void Link::secure() {
  stream_.handshake_as_client(tls_, host_, [self = shared_from_this()](const ErrorCode& ec) {
    if (self->state_ != State::Connecting) return;
    // A certificate that is not trusted now will not be in a second either.
    const bool distrusted = ec.category() == asio::error::get_ssl_category();
    if (distrusted) return self->end(LinkEnd::Kind::Refused, "TLS: " + ec.message());
    if (ec) return self->fail(ec, "TLS");
    self->say_hello();
  });
}

void Link::say_hello() {
  state_ = State::AwaitingWelcome;
  write(std::move(hello_));
  read();
}

// --- reading ---

void Link::read() {
  stream_.read_some(asio::buffer(read_buffer_),
                    [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                      self->on_read(ec, size);
                    });
}

void Link::on_read(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  // With TLS the server leaves out the farewell: messages have lengths.
  if (ec == asio::error::eof || ec == asio::ssl::error::stream_truncated) {
    return end(LinkEnd::Kind::Lost, "the server closed the connection");
  }
  if (ec) return fail(ec, "read");
  bytes_received_ += size;
  if (state_ == State::Running || state_ == State::Draining) expect_sign_of_life();
  take(std::span(read_buffer_).first(size));
  if (state_ != State::Ended && reads_) read();
}

void Link::stop_reading() {
  reads_ = false;
  timer_.cancel();
}

void Link::take(std::span<const std::byte> input) {
  while (state_ != State::Ended) {
    protocol::Decoder::Result result = decoder_.next(input);
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) return;
    if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
      return end(LinkEnd::Kind::Refused, "the server sent no valid message: " + failure->what);
    }
    auto* const envelope = std::get_if<Envelope>(&result);
    if (envelope == nullptr) return refuse_kind();
    visit(*envelope);
  }
}

void Link::visit(Envelope& envelope) {
  const Envelope::BodyCase body = envelope.body_case();
  if (state_ == State::AwaitingWelcome && (body == Envelope::kComposite)) {
    return end(LinkEnd::Kind::Refused, "the server sent a composite before its welcome");
  }
  switch (body) {
    case Envelope::kWelcome:
      if (state_ != State::AwaitingWelcome) {
        return end(LinkEnd::Kind::Refused, "the server sent a second welcome");
      }
      state_ = State::Running;
      expect_sign_of_life();
      events_.welcomed(std::move(*envelope.mutable_welcome()));
      if (is_idle()) events_.idle();
      return;
    case Envelope::kComposite:
      return events_.composite(std::move(*envelope.mutable_composite()));
    case Envelope::kPing: {
      Envelope pong;
      pong.mutable_pong()->set_nonce(envelope.ping().nonce());
      return send_control(pong);
    }
    case Envelope::kPong:
      return;
    case Envelope::kError:
      return on_error(*envelope.mutable_error());
    case Envelope::kBusy:
      return end({.kind = LinkEnd::Kind::Busy,
                  .text = "the server is busy: " + envelope.busy().reason(),
                  .retry_after = std::chrono::milliseconds(envelope.busy().retry_after_ms()),
                  .code = {}});
    case Envelope::kDraining:
      // It answers what it has and closes then; frames sent from now on would be thrown away.
      if (state_ == State::Running) state_ = State::Draining;
      return events_.draining();
    case Envelope::kHello:
    case Envelope::kCameraFrame:
    case Envelope::kEnvironment:
    case Envelope::kGoodbye:
    case Envelope::BODY_NOT_SET:
      return refuse_kind();
  }
}

void Link::refuse_kind() {
  end(LinkEnd::Kind::Refused, "the server sent a message that servers do not send");
}

void Link::on_error(Error& error) {
  if (!error.closes()) return events_.error(std::move(error));
  const std::string text = "the server refused: " + Error::Code_Name(error.code()) +
                           (error.text().empty() ? "" : ": " + error.text());
  end({.kind = is_final(error.code()) ? LinkEnd::Kind::Refused : LinkEnd::Kind::Lost,
       .text = text,
       .retry_after = {},
       .code = error.code()});
}

// --- writing ---

void Link::write_frame(std::string bytes) {
  write(std::move(bytes));
}

void Link::write_first(std::string bytes) {
  control_.push_back(std::move(bytes));
  if (writing_.empty()) write_next();
}

void Link::send_control(const Envelope& envelope) {
  // A server that is not read from is asked for nothing: pings wait like everything else.
  if (control_.size() < protocol::kMaxQueuedControl) write_first(protocol::encode(envelope));
}

void Link::write(std::string bytes) {
  writing_ = std::move(bytes);
  stream_.write(asio::buffer(writing_),
                [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                  if (self->state_ == State::Ended) return;
                  if (ec) return self->fail(ec, "write");
                  self->bytes_sent_ += size;
                  self->writing_.clear();
                  self->write_next();
                });
}

void Link::write_next() {
  if (!control_.empty()) {
    std::string bytes = std::move(control_.front());
    control_.pop_front();
    return write(std::move(bytes));
  }
  if (is_idle()) events_.idle();
}

// --- time and ends ---

void Link::expect_within(std::chrono::milliseconds time, std::string what) {
  timer_.expires_after(time);  // cancels the wait that is under way
  timer_.async_wait([self = shared_from_this(), what = std::move(what)](const ErrorCode& ec) {
    if (ec) return;
    const auto kind = self->state_ == State::Closing ? LinkEnd::Kind::Closed : LinkEnd::Kind::Lost;
    self->end(kind, what);
  });
}

void Link::expect_sign_of_life() {
  if (reads_) expect_within(protocol::kIdleTimeout, "the server has fallen silent");
}

void Link::close() {
  if (state_ == State::Ended || state_ == State::Closing) return;
  if (state_ == State::Connecting) return end(LinkEnd::Kind::Closed, {});
  state_ = State::Closing;
  Envelope goodbye;
  goodbye.mutable_goodbye();
  send_control(goodbye);
  expect_within(protocol::kLinger, {});
}

void Link::fail(const ErrorCode& ec, const char* what) {
  end(LinkEnd::Kind::Lost, std::string(what) + ": " + ec.message());
}

void Link::end(LinkEnd end) {
  const State before = std::exchange(state_, State::Ended);
  if (before == State::Ended) return;
  resolver_.cancel();
  stream_.close();
  timer_.cancel();
  if (before == State::Closing) end.kind = LinkEnd::Kind::Closed;
  events_.ended(end);
}

}  // namespace amalgam::client
