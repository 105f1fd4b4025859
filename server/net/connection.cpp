#include "net/connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "common/log.h"
#include "common/tcp_options.h"
#include "net/wire.h"
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

Connection::Connection(asio::ip::tcp::socket socket, ConnectionLimits::Ticket ticket,
                       std::uint64_t id, ServerContext& context, OnEnd on_end)
    : socket_(std::move(socket)),
      timer_(socket_.get_executor()),
      ticket_(std::move(ticket)),
      context_(context),
      id_(id),
      on_end_(std::move(on_end)),
      deadlines_(context.config.session, Clock::now()),
      read_buffer_(protocol::kMaxBeforeHelloBytes),
      decoder_(protocol::limits_before_hello()),
      slot_(protocol::kMaxQueuedControl),
      conversation_(id, peer_of(socket_), *this, context) {}

void Connection::start() {
  common::set_tcp_options(socket_.native_handle(),
                          {context_.config.session.idle_timeout, protocol::kUnsentBytes});
  guarded([&] {
    wait();
    read();
  });
}

// --- reading ---

void Connection::read() {
  socket_.async_read_some(asio::buffer(read_buffer_),
                          [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                            self->guarded([&] { self->on_read(ec, size); });
                          });
}

void Connection::on_read(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "read");
  // While closing, what still arrives is thrown away: unread bytes would make the kernel reset the
  // connection, and the client would never see the Error that tells it why.
  if (state_ == State::Open) take(std::span(read_buffer_).first(size));
  if (state_ != State::Ended) read();
}

void Connection::take(std::span<const std::byte> input) {
  while (state_ == State::Open) {
    const protocol::Decoder::Result result = decoder_.next(input);
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) break;
    if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
      return fail(Error::PROTOCOL_ERROR, failure->what);
    }
    deadlines_.received_message(Clock::now());
    guarded([&] { conversation_.visit(std::get<Envelope>(result)); });
  }
  deadlines_.received_part(decoder_.bytes_of_unfinished(), Clock::now());
}

// --- writing ---

void Connection::send(const Envelope& message) {
  // A peer that does not read its answers loses some; the write time-out ends it if that goes on.
  if (!slot_.put_control(message)) {
    common::log_debug(conversation_.name() + ": an answer was dropped");
  }
  write();
}

bool Connection::send_answer(Answer answer) {
  const bool replaced = slot_.put_answer(std::move(answer));
  write();
  return replaced;
}

void Connection::send_last(const Envelope& error) {
  slot_.drop_control();
  send(error);
  close();
}

void Connection::write() {
  std::optional<std::string> bytes = slot_.begin_write(conversation_.skipped());
  if (!bytes) return;
  writing_ = std::move(*bytes);
  deadlines_.write_begun(Clock::now());
  asio::async_write(socket_, asio::buffer(writing_),
                    [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                      self->guarded([&] { self->on_written(ec, size); });
                    });
}

void Connection::on_written(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "write");
  if (slot_.writing_answer()) conversation_.written(size);
  slot_.end_write();
  deadlines_.write_ended();
  write();
  if (state_ == State::Closing) finish_sending();
  close_if_drained();
}

// --- time ---

void Connection::wait() {
  // Setting a new time cancels the wait that is under way.
  timer_.expires_at(state_ == State::Closing ? linger_end_ : deadlines_.next());
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    self->guarded([&] { self->on_time(ec); });
  });
}

void Connection::on_time(const ErrorCode& ec) {
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

void Connection::on_passed(Deadlines::Passed passed) {
  switch (passed) {
    case Deadlines::Passed::Hello:
      return fail(Error::AUTH_TIMEOUT, "no complete hello in time");
    case Deadlines::Passed::SlowSender:
      return fail(Error::SLOW_SENDER, "a message came too slowly");
    case Deadlines::Passed::SlowReader:
      // Nothing can be said to somebody who does not read.
      context_.metrics.error_sent(Error::SLOW_READER);
      common::log_info(conversation_.name() + ": evicted, it does not read");
      return end();
    case Deadlines::Passed::Idle:
      fail(Error::IDLE_TIMEOUT, "nothing was heard, not even a pong");
      // Its error is on the way or will never be; a peer that is gone need not be waited for.
      return end();
  }
}

// --- the conversation's wishes ---

void Connection::welcomed() {
  ticket_->authenticated();
  decoder_.set_limits(protocol::limits_of_server());
  deadlines_.authenticated(Clock::now());
  wait();
}

// Steps come from the renderer's thread, and the connection may have ended by then.
std::function<void(Line::Step)> Connection::posting() {
  return [executor = socket_.get_executor(), weak = weak_from_this()](Step step) {
    asio::post(executor, [weak, step = std::move(step)] {
      const auto self = weak.lock();
      if (!self) return;
      self->guarded([&] {
        step();
        self->close_if_drained();
      });
    });
  };
}

// --- errors and ends ---

// The one place where what is thrown in a session is caught: bad input is answered, anything else
// ends this session and no other.
template <typename F>
void Connection::guarded(F step) {
  try {
    try {
      step();
    } catch (const ClientError& error) {
      conversation_.answer(error);
    }
  } catch (const std::exception& error) {
    common::log_error(conversation_.name() + ": " + error.what());
    end();
  }
}

void Connection::close() {
  if (state_ != State::Open) return;
  if (slot_.drop_answer()) conversation_.dropped();
  conversation_.leave();
  state_ = State::Closing;
  linger_end_ = Clock::now() + context_.config.session.linger;
  wait();
  finish_sending();
}

void Connection::finish_sending() {
  ErrorCode ignored;
  if (slot_.empty()) socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

void Connection::drain(std::chrono::milliseconds deadline) {
  guarded([&] {
    conversation_.drain(deadline);
    close_if_drained();
  });
}

void Connection::close_if_drained() {
  if (state_ == State::Open && conversation_.drained() && slot_.empty()) close();
}

void Connection::end() {
  if (std::exchange(state_, State::Ended) == State::Ended) return;
  if (slot_.drop_answer()) conversation_.dropped();
  conversation_.leave();
  ErrorCode ignored;
  socket_.close(ignored);
  timer_.cancel();
  ticket_.reset();
  on_end_(id_);
}

void Connection::lost(const ErrorCode& ec, const char* what) {
  if (state_ != State::Closing) {
    common::log_info(conversation_.name() + ": " + what + ": " + ec.message());
  }
  end();
}

}  // namespace amalgam::net
