// Accepts clients' connections. Refuses those above the caps, and addresses that sent too many
// wrong tokens, with Busy, before anything is allocated for them. Hands the others on.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <functional>
#include <string>

#include "net/accept_loop.h"
#include "net/back_off.h"
#include "net/connection_limits.h"
#include "net/metrics.h"
#include "net/server_config.h"

namespace amalgam::net {

class Listener {
 public:
  struct Admitted {
    boost::asio::ip::tcp::socket socket;
    ConnectionLimits::Ticket ticket;
    bool by_proxy = false;  // of a trusted proxy, which says first whom it speaks for
  };
  using OnAdmitted = std::function<void(Admitted)>;

  // What is said to somebody who is refused.
  using Refusal =
      std::function<std::string(std::chrono::milliseconds retry_after, const std::string& reason)>;

  // All outlive the Listener.
  Listener(boost::asio::io_context& io, const common::HostPort& address, const ServerConfig& config,
           ConnectionLimits& limits, BackOff& back_off, Metrics& metrics, Refusal refusal,
           OnAdmitted on_admitted);

  void listen() { accept_loop_.listen(); }
  void start() { accept_loop_.start(); }
  void restart() { accept_loop_.restart(); }
  void close() { accept_loop_.close(); }
  common::HostPort address() const { return accept_loop_.address(); }

 private:
  void judge(boost::asio::ip::tcp::socket socket);
  void refuse(boost::asio::ip::tcp::socket& socket, const char* label,
              std::chrono::milliseconds retry_after, const std::string& reason);

  const ServerConfig& config_;
  ConnectionLimits& limits_;
  BackOff& back_off_;
  Metrics& metrics_;
  Refusal refusal_;
  OnAdmitted on_admitted_;
  AcceptLoop accept_loop_;
};

}  // namespace amalgam::net
