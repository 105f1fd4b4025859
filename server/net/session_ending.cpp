// The end of a session, and its report.
#include <boost/asio/ip/tcp.hpp>
#include <utility>

#include "net/session.h"
#include "net/wire.h"

namespace amalgam::net {

namespace asio = boost::asio;

// Writes the queue, then waits a limited time for the client to close.
void Session::close(std::chrono::milliseconds linger) {
  if (state_ == State::Closing || state_ == State::Ended) return;
  if (slot_.drop_composite()) ledger_.skip(Skip::Closed);
  leave_renderer();
  state_ = State::Closing;
  linger_end_ = Clock::now() + linger;
  wait();
  finish_sending();
}

void Session::finish_sending() {
  ErrorCode ignored;
  if (slot_.empty()) socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

void Session::drain(std::chrono::milliseconds deadline) {
  if (state_ != State::AwaitingHello && state_ != State::Running) return;
  send(draining_message(deadline));
  if (state_ == State::AwaitingHello) return close(context_.config.session.linger);
  state_ = State::Draining;
  close_if_drained();
}

void Session::close_if_drained() {
  if (state_ == State::Draining && ledger_.in_flight() == 0 && slot_.empty()) {
    close(context_.config.session.linger);
  }
}

void Session::end() {
  if (std::exchange(state_, State::Ended) == State::Ended) return;
  if (slot_.drop_composite()) ledger_.skip(Skip::Closed);
  leave_renderer();
  ErrorCode ignored;
  socket_.close(ignored);
  timer_.cancel();
  ticket_.reset();
  context_.on_end(id_);
}

void Session::leave_renderer() {
  if (!view_) return;
  context_.service.close_view(*std::exchange(view_, std::nullopt));
  context_.metrics.session_closed();
  ledger_.abandon();
}

std::string Session::name() const {
  return "session " + std::to_string(id_) + " (" + peer_ + ")";
}

SessionReport Session::report() const {
  constexpr const char* kNames[] = {"awaiting_hello", "running", "draining", "closing", "ended"};
  SessionReport report;
  report.id = id_;
  report.peer = peer_;
  report.state = kNames[static_cast<int>(state_)];
  report.width = camera_.width;
  report.height = camera_.height;
  report.received = ledger_.received_count();
  report.sent = ledger_.sent_count();
  report.skipped = ledger_.skipped_count();
  report.in_flight = ledger_.in_flight();
  return report;
}

}  // namespace amalgam::net
