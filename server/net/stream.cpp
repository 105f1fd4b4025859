#include "net/stream.h"

#include <boost/asio/write.hpp>
#include <utility>

namespace amalgam::net {

namespace asio = boost::asio;

void Stream::handshake(std::shared_ptr<asio::ssl::context> context, OnDone done) {
  context_ = std::move(context);
  tls_.emplace(socket_, *context_);
  tls_->async_handshake(asio::ssl::stream_base::server, std::move(done));
}

void Stream::read_some(asio::mutable_buffer buffer, OnSize done) {
  tls_ ? tls_->async_read_some(buffer, std::move(done))
       : socket_.async_read_some(buffer, std::move(done));
}

void Stream::write(asio::const_buffer buffer, OnSize done) {
  tls_ ? asio::async_write(*tls_, buffer, std::move(done))
       : asio::async_write(socket_, buffer, std::move(done));
}

// Without TLS's own farewell: messages have lengths, so nobody takes a cut for an end.
void Stream::finish_sending() {
  ErrorCode ignored;
  socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

void Stream::close() {
  ErrorCode ignored;
  socket_.close(ignored);
}

}  // namespace amalgam::net
