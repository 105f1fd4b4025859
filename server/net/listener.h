// Accepts clients' connections. Refuses those above the caps with Busy, before anything is
// allocated for them, and hands the others on.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <string>

#include "net/accept_loop.h"
#include "net/connection_limits.h"
#include "net/metrics.h"
#include "net/server_config.h"

namespace amalgam::net {

class Listener {
 public:
  using OnAdmitted = std::function<void(boost::asio::ip::tcp::socket, ConnectionLimits::Ticket)>;

  Listener(boost::asio::io_context& io, const common::HostPort& address, ConnectionLimits& limits,
           Metrics& metrics, OnAdmitted on_admitted);

  void listen() { accept_loop_.listen(); }
  void start() { accept_loop_.start(); }
  void close() { accept_loop_.close(); }
  common::HostPort address() const { return accept_loop_.address(); }

 private:
  void judge(boost::asio::ip::tcp::socket socket);

  ConnectionLimits& limits_;
  Metrics& metrics_;
  OnAdmitted on_admitted_;
  std::string busy_;  // encoded once, so that refusing is cheap
  AcceptLoop accept_loop_;
};

}  // namespace amalgam::net
