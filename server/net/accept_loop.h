// Accepts connections on one address until it is closed. Pauses if the process runs out of
// descriptors or memory, instead of spinning or ending.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

#include "net/server_config.h"

namespace amalgam::net {

class AcceptLoop {
 public:
  using OnAccept = std::function<void(boost::asio::ip::tcp::socket)>;

  // Binds the address, so that a port in use throws at start-up, but does not listen yet.
  AcceptLoop(boost::asio::io_context& io, const common::HostPort& address, OnAccept on_accept);

  // Throws std::runtime_error. From here on connections queue up; start() accepts them.
  void listen();
  void start();
  // Begins to wait anew. For when something was thrown past all handlers, which may have lost this
  // one's: Asio itself allocates between a connection and its handler.
  void restart();
  void close();
  // With the actual port if 0 was given. From any thread, also when closed.
  const common::HostPort& address() const { return address_; }

 private:
  void accept();
  void on_accept(const boost::system::error_code& ec, boost::asio::ip::tcp::socket socket);
  void pause();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  OnAccept on_accept_;
  common::HostPort address_;
  bool started_ = false;
};

}  // namespace amalgam::net
