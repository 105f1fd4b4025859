#include "net/agent_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "net/say_and_close.h"

namespace amalgam::net {

AgentCheck::AgentCheck(boost::asio::io_context& io, const common::HostPort& address,
                       std::function<std::string()> line)
    : accept_loop_(io, address, [line = std::move(line)](boost::asio::ip::tcp::socket socket) {
        say_and_close(socket, line());
      }) {}

void AgentCheck::start() {
  accept_loop_.listen();
  accept_loop_.start();
}

std::string agent_line(double free) {
  const int percent = static_cast<int>(std::ceil(100.0 * std::clamp(free, 0.01, 1.0)));
  return "ready up " + std::to_string(percent) + "%\n";
}

}  // namespace amalgam::net
