// A byte stream between a client and a server: TCP, or TLS 1.3 over it. Used by both ends. One read
// and one write at a time.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace amalgam::protocol {

class Stream {
 public:
  using ErrorCode = boost::system::error_code;
  using OnSize = std::function<void(const ErrorCode&, std::size_t)>;
  using OnDone = std::function<void(const ErrorCode&)>;
  using Tls = std::shared_ptr<boost::asio::ssl::context>;

  explicit Stream(boost::asio::ip::tcp::socket socket) : socket_(std::move(socket)) {}

  // From here on everything is encrypted.
  void handshake_as_server(Tls context, OnDone done);
  // Fails unless the server's certificate is the host's, a name or an address.
  void handshake_as_client(Tls context, const std::string& host, OnDone done);

  void read_some(boost::asio::mutable_buffer buffer, OnSize done);
  void write(boost::asio::const_buffer buffer, OnSize done);
  void finish_sending();
  void close();

  boost::asio::ip::tcp::socket& socket() { return socket_; }

  // Calls f with Asio's stream, for whoever speaks another protocol over the same bytes.
  template <typename F>
  void visit(F f) {
    tls_ ? f(*tls_) : f(socket_);
  }

 private:
  boost::asio::ip::tcp::socket socket_;
  Tls context_;
  std::optional<boost::asio::ssl::stream<boost::asio::ip::tcp::socket&>> tls_;
};

}  // namespace amalgam::protocol
