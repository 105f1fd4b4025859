// Accepts connections on one address until it is closed. Pauses if the process runs out of
// descriptors, instead of spinning.
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
  void start() { accept(); }
  void close();
  common::HostPort address() const;  // with the actual port if 0 was given

 private:
  void accept();
  void on_accept(const boost::system::error_code& ec, boost::asio::ip::tcp::socket socket);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  OnAccept on_accept_;
};

}  // namespace amalgam::net
