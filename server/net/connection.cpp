#include "net/connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/error.hpp>
#include <utility>

#include "common/log.h"
#include "common/tcp_options.h"
#include "net/address_key.h"
#include "net/proxy_header.h"
#include "net/quietly.h"
#include "net/wire.h"
#include "protocol/limits.h"

namespace amalgam::net {

namespace asio = boost::asio;
using protocol::Envelope;
using protocol::Error;

namespace {

// Between two looks at an incomplete PROXY header.
constexpr std::chrono::milliseconds kProxyPause{20};

std::string peer_of(const asio::ip::tcp::socket& socket) {
  boost::system::error_code ec;
  const auto endpoint = socket.remote_endpoint(ec);
  return ec ? "unknown" : text_of(endpoint);
}

}  // namespace

Connection::Connection(std::unique_ptr<Transport> transport, ConnectionLimits::Ticket ticket,
                       bool by_proxy, std::uint64_t id, Shared& shared, OnEnd on_end)
    : transport_(std::move(transport)),
      timer_(transport_->socket().get_executor()),
      ticket_(std::move(ticket)),
      by_proxy_(by_proxy),
      opened_(transport_->speaks_at_once()),
      shared_(shared),
      context_(shared.context),
      id_(id),
      on_end_(std::move(on_end)),
      deadlines_(context_.config.session, Clock::now()),
      read_buffer_(protocol::kMaxBeforeHelloBytes),
      decoder_(protocol::limits_before_hello()),
      slot_(protocol::kMaxQueuedControl),
      conversation_(id, peer_of(transport_->socket()), *this, context_) {}

void Connection::start() {
  common::set_tcp_options(transport_->socket().native_handle(),
                          {.user_timeout = context_.config.session.idle_timeout,
                           .unsent_bytes = protocol::kUnsentBytes,
                           .send_buffer_bytes = protocol::kSendBufferBytes});
  guarded([&] {
    wait();
    by_proxy_ ? read_proxy_header() : open();
  });
}

// --- before the conversation ---

void Connection::read_proxy_header() {
  transport_->socket().async_wait(asio::ip::tcp::socket::wait_read,
                                  [self = shared_from_this()](const ErrorCode& ec) {
                                    self->guarded([&] { self->on_proxy_bytes(ec); });
                                  });
}

void Connection::on_proxy_bytes(const ErrorCode& failed) {
  if (state_ == State::Ended) return;
  if (failed) return lost(failed, "read");
  const ProxyRead taken = take_proxy_header(transport_->socket());
  if (const auto* ec = std::get_if<ErrorCode>(&taken)) return lost(*ec, "read");
  if (const auto* defect = std::get_if<ProxyDefect>(&taken)) {
    return fail(Error::PROTOCOL_ERROR, defect->what);
  }
  if (std::holds_alternative<ProxyNeedsMore>(taken)) return wait_for_proxy();
  const auto& header = std::get<ProxyHeader>(taken);
  // Whoever is refused is not worth a TLS handshake; without one it can be told why.
  if (header.client && !is_admitted(*header.client) && transport_->encrypted()) return;
  open();
}

// A header comes in one packet, or its sender may take its time: readiness would be told again and
// again for what is there already.
void Connection::wait_for_proxy() {
  proxy_timer_.expires_after(kProxyPause);
  proxy_timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec && self->state_ == State::Open) self->guarded([&] { self->read_proxy_header(); });
  });
}

// From here on the connection counts as that of the client.
bool Connection::is_admitted(const asio::ip::tcp::endpoint& client) {
  const std::string key = address_key(client.address());
  conversation_.set_peer(text_of(client));
  if (const auto left = shared_.back_off.left(key, Clock::now()); left.count() > 0) {
    context_.metrics.refused("back_off");
    send_last(busy_message(left, "too many failed attempts"));
    return false;
  }
  if (const auto refusal = shared_.limits.move(*ticket_, key)) {
    context_.metrics.refused(to_string(*refusal));
    send_last(busy_message(protocol::kRetryAfter, "too many connections"));
    return false;
  }
  return true;
}

void Connection::open() {
  transport_->open(
      [self = shared_from_this()](const ErrorCode& ec, Transport::Opened opened) {
        self->guarded([&] { self->on_opened(ec, opened); });
      },
      [weak = weak_from_this()] {
        if (const auto self = weak.lock()) self->deadlines_.served(Clock::now());
      });
}

void Connection::on_opened(const ErrorCode& ec, Transport::Opened opened) {
  if (state_ == State::Ended) return;
  // A failed handshake costs us a key exchange. A balancer that only looks ends without this error.
  if (ec.category() == asio::error::get_ssl_category()) refused();
  if (ec) return lost(ec, "handshake");
  if (opened == Transport::Opened::Nothing) {
    slot_.drop_control();  // nobody is there who would understand it
    close();
    finish_sending();
  } else {
    opened_ = true;
    write();  // a farewell may be waiting already
  }
  read();
}

// --- reading ---

void Connection::read() {
  // In pieces of 4 KiB a frame would take many rounds. Grown here, while nobody looks into it.
  if (welcomed_) read_buffer_.resize(protocol::kReadBufferBytes);
  transport_->read(
      asio::buffer(read_buffer_),
      [self = shared_from_this()](const ErrorCode& ec, const Transport::Received& received) {
        self->guarded([&] { self->on_read(ec, received); });
      });
}

void Connection::on_read(const ErrorCode& ec, const Transport::Received& received) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "read");
  common::acknowledge_now(transport_->socket().native_handle());
  // While closing, what still arrives is thrown away: unread bytes would make the kernel reset the
  // connection, and the client would never see the Error that tells it why.
  if (state_ == State::Open) take(std::span(read_buffer_).first(received.size), received);
  if (state_ != State::Ended) read();
}

void Connection::take(std::span<const std::byte> input, const Transport::Received& received) {
  if (received.defect) return fail(Error::PROTOCOL_ERROR, received.defect);
  do {
    const std::size_t left = input.size();
    const std::size_t begun = decoder_.bytes_of_unfinished();
    const protocol::Decoder::Result result =
        received.part ? decoder_.next_part(input, *received.part) : decoder_.next(input);
    const std::size_t size_of_last = begun + left - input.size();
    if (std::holds_alternative<protocol::Decoder::NeedMore>(result)) break;
    if (const auto* failure = std::get_if<protocol::Decoder::Failure>(&result)) {
      return fail(Error::PROTOCOL_ERROR, failure->what);
    }
    deadlines_.received_message(Clock::now());
    if (size_of_last > protocol::kMaxControlBytes) context_.large_messages = true;
    guarded([&] {
      if (const auto* refused = std::get_if<protocol::Decoder::TooManyPoses>(&result)) {
        conversation_.refuse_poses(refused->frame_id, refused->message_bytes);
      } else {
        conversation_.visit(std::get<Envelope>(result));
      }
    });
  } while (state_ == State::Open && !input.empty());
  deadlines_.received_part(decoder_.bytes_of_unfinished(), Clock::now());
}

// --- writing ---

void Connection::send(const Envelope& message) {
  // A peer that does not read its answers loses some; the write time-out ends it if that goes on.
  slot_.put_control(message) ? conversation_.said(message) : conversation_.not_said();
  write();
}

bool Connection::send_answer(Answer answer) {
  const bool replaced = slot_.put_answer(std::move(answer));
  write();
  return replaced;
}

void Connection::send_last(const Envelope& message) {
  slot_.drop_control();
  send(message);
  close();
}

void Connection::write() {
  // Before the handshake is over nothing can be said: the client would take it for a part of that.
  if (!opened_) return;
  std::optional<std::string> bytes =
      slot_.begin_write(conversation_.skipped(), pings_.may_write_composite());
  if (!bytes) return;
  writing_ = std::move(*bytes);
  if (slot_.writing_answer()) append_ping();
  deadlines_.write_begun(Clock::now());
  transport_->write(asio::buffer(writing_),
                    [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                      self->guarded([&] { self->on_written(ec, size); });
                    });
}

void Connection::append_ping() {
  const Envelope ping = ping_message(pings_.after_composite(Clock::now()));
  conversation_.writing(ping);
  writing_ += protocol::encode(ping);
  deadlines_.unread_since(pings_.unread_since());
}

void Connection::heard_pong(std::uint64_t nonce) {
  pings_.heard_pong(nonce, Clock::now());
  deadlines_.unread_since(pings_.unread_since());
  write();
}

void Connection::on_written(const ErrorCode& ec, std::size_t size) {
  if (state_ == State::Ended) return;
  if (ec) return lost(ec, "write");
  if (slot_.writing_answer()) conversation_.written(size);
  if (size > protocol::kMaxControlBytes) context_.large_messages = true;
  slot_.end_write();
  std::string().swap(writing_);  // it may have been an image, whose memory assigning would keep
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
  if (deadlines_.ping_due(now)) send(ping_message(pings_.next(now)));
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
      common::log_info(common::LogKind::Session,
                       conversation_.name() + ": evicted, it does not read");
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
  shared_.back_off.succeeded(ticket_->address());
  welcomed_ = true;
  decoder_.set_limits(protocol::limits_of_server());
  deadlines_.authenticated(Clock::now());
  // Before there are composites to hold it up.
  send(ping_message(pings_.next(Clock::now())));
  wait();
}

void Connection::refused() {
  shared_.back_off.failed(ticket_->address(), Clock::now());
}

// Steps come from the renderer's thread; the connection may have ended by then.
std::function<void(Line::Step)> Connection::posting() {
  return [executor = transport_->socket().get_executor(), weak = weak_from_this()](Step step) {
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

SessionReport Connection::report() const {
  SessionReport report = conversation_.report();
  report.transport = transport_->name();
  return report;
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
    quietly([&] {
      common::log_error(common::LogKind::Session, conversation_.name() + ": " + error.what());
    });
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
  if (slot_.empty()) transport_->finish_sending();
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

// Must work when memory is missing: nothing here allocates, or it does not matter if it fails.
void Connection::end() {
  if (std::exchange(state_, State::Ended) == State::Ended) return;
  quietly([&] {
    if (slot_.drop_answer()) conversation_.dropped();
    conversation_.leave();
  });
  transport_->close();
  quietly([&] { timer_.cancel(); });
  quietly([&] { proxy_timer_.cancel(); });
  ticket_.reset();
  on_end_(id_);
}

void Connection::lost(const ErrorCode& ec, const char* what) {
  if (state_ != State::Closing) {
    common::log_info(common::LogKind::Session,
                     conversation_.name() + ": " + what + ": " + ec.message());
  }
  end();
}

}  // namespace amalgam::net
