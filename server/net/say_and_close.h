// A last word to a peer that is not waited for.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace amalgam::net {

// Best effort, without waiting: a few bytes fit the buffer of a new socket.
inline void say_and_close(boost::asio::ip::tcp::socket& socket, const std::string& bytes) {
  boost::system::error_code ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(boost::asio::buffer(bytes), ignored);
  socket.shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  socket.close(ignored);
}

}  // namespace amalgam::net
