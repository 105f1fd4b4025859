#include "net/accept_loop.h"

#include <boost/asio/error.hpp>
#include <boost/asio/ip/address.hpp>
#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/log.h"
#include "net/quietly.h"

namespace amalgam::net {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

// Long enough not to spin while descriptors are short, short enough for nobody to notice.
constexpr std::chrono::milliseconds kPauseAfterError{100};

tcp::endpoint endpoint_of(const common::HostPort& address) {
  error_code ec;
  const auto ip = asio::ip::make_address(address.host, ec);
  if (ec) throw std::runtime_error("'" + address.host + "' is not a numeric IP address");
  return {ip, address.port};
}

}  // namespace

AcceptLoop::AcceptLoop(asio::io_context& io, const common::HostPort& address, OnAccept on_accept)
    : acceptor_(io), pause_(io), on_accept_(std::move(on_accept)) {
  const tcp::endpoint endpoint = endpoint_of(address);
  error_code ec;
  acceptor_.open(endpoint.protocol(), ec);
  if (!ec) acceptor_.set_option(tcp::acceptor::reuse_address(true), ec);
  if (!ec) acceptor_.bind(endpoint, ec);
  if (ec) throw std::runtime_error("cannot listen on " + to_string(address) + ": " + ec.message());
  const tcp::endpoint bound = acceptor_.local_endpoint();
  address_ = {bound.address().to_string(), bound.port()};
}

void AcceptLoop::listen() {
  error_code ec;
  acceptor_.listen(asio::socket_base::max_listen_connections, ec);
  if (ec) throw std::runtime_error("cannot listen: " + ec.message());
}

void AcceptLoop::close() {
  error_code ignored;
  acceptor_.close(ignored);
  pause_.cancel();
}

void AcceptLoop::start() {
  started_ = true;
  accept();
}

void AcceptLoop::restart() {
  if (!started_ || !acceptor_.is_open()) return;
  error_code ignored;
  acceptor_.cancel(ignored);
  pause_.cancel();
  accept();
}

void AcceptLoop::accept() {
  acceptor_.async_accept([this](const error_code& ec, tcp::socket socket) {
    if (ec == asio::error::operation_aborted) return;
    on_accept(ec, std::move(socket));
  });
}

// The one place where what is thrown for a new connection is caught: it alone is lost.
void AcceptLoop::on_accept(const error_code& ec, tcp::socket socket) {
  if (!acceptor_.is_open()) return;
  if (ec) {
    quietly([&] { common::log_warn(common::LogKind::Accept, "accept: " + ec.message()); });
    return pause();
  }
  try {
    on_accept_(std::move(socket));
  } catch (const std::exception& error) {
    quietly([&] { common::log_error(common::LogKind::Accept, error.what()); });
  }
  accept();
}

void AcceptLoop::pause() {
  pause_.expires_after(kPauseAfterError);
  pause_.async_wait([this](const error_code& cancelled) {
    if (cancelled) return;
    if (acceptor_.is_open()) accept();
  });
}

}  // namespace amalgam::net
