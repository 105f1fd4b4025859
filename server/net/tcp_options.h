// Kernel options of a client's socket: small messages leave at once, a vanished peer is noticed,
// and the kernel does not hoard frames that newest-wins could still replace.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <string>

namespace amalgam::net {

// Best effort: a kernel without one of them still serves.
void set_tcp_options(boost::asio::ip::tcp::socket& socket, std::chrono::milliseconds user_timeout);

// Address and port of the other end, for logs.
std::string peer_of(const boost::asio::ip::tcp::socket& socket);

}  // namespace amalgam::net
