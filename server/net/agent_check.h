// The agent port: tells a load balancer how much of this server is free. HAProxy connects now and
// then, reads one line and takes it for the server's weight (its "agent-check").
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <string>

#include "net/accept_loop.h"

namespace amalgam::net {

class AgentCheck {
 public:
  // line: called for each connection. Binds the address; throws std::runtime_error.
  AgentCheck(boost::asio::io_context& io, const common::HostPort& address,
             std::function<std::string()> line);

  void start();
  void restart() { accept_loop_.restart(); }
  common::HostPort address() const { return accept_loop_.address(); }

 private:
  AcceptLoop accept_loop_;
};

// "ready up NN%": a server that was draining, and was started anew, takes clients again only if it
// says "ready". free: 0..1. Never below 1 %, because a balancer closes connections when all weights
// are 0, and a full server says better when to come back.
std::string agent_line(double free);

}  // namespace amalgam::net
