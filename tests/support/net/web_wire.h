// A WebSocket client's side of a connection, for tests: Beast opens it and reads, while bytes are
// written as they are given, so that bad ones can be sent too.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "net/beast_stream.h"
#include "net/server_config.h"
#include "protocol/stream.h"

namespace amalgam::test {

class WebWire {
 public:
  // handle: a connected socket, which the WebWire does not close. origin: empty, or the page's.
  // tls: null, or what to encrypt with. Throws std::runtime_error if there is no session.
  WebWire(int handle, const common::HostPort& server, const std::string& origin = "",
          protocol::Stream::Tls tls = nullptr);

  // The next message; nothing at the end. Throws std::runtime_error after ten seconds.
  std::optional<std::string> read();
  // False if the server has closed.
  bool write(const std::string& message);

  // With which the server closed; 0: it did not.
  int close_code() const { return socket_.reason().code; }

  // A stream of Envelopes with lengths as WebSocket's frames, in whatever pieces it comes.
  std::string frames_of(std::string_view stream);

 private:
  template <typename Begin>
  boost::system::error_code wait(Begin begin);

  boost::asio::io_context io_;
  protocol::Stream stream_;
  boost::beast::websocket::stream<net::BeastStream, false> socket_;
  boost::beast::flat_buffer buffer_;
  std::size_t length_bytes_ = 0, length_ = 0, sent_ = 0;  // of the message being cut
};

}  // namespace amalgam::test
