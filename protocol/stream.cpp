#include "protocol/stream.h"

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/write.hpp>
#include <utility>

namespace amalgam::protocol {

namespace asio = boost::asio;

void Stream::handshake_as_server(Tls context, OnDone done) {
  context_ = std::move(context);
  tls_.emplace(socket_, *context_);
  tls_->async_handshake(asio::ssl::stream_base::server, std::move(done));
}

void Stream::handshake_as_client(Tls context, const std::string& host, OnDone done) {
  context_ = std::move(context);
  tls_.emplace(socket_, *context_);
  tls_->set_verify_mode(asio::ssl::verify_peer);
  tls_->set_verify_callback(asio::ssl::host_name_verification(host));
  ErrorCode ec;
  asio::ip::make_address(host, ec);
  // Addresses have no place in the name that a server chooses its certificate by.
  if (ec) SSL_set_tlsext_host_name(tls_->native_handle(), host.c_str());
  tls_->async_handshake(asio::ssl::stream_base::client, std::move(done));
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

}  // namespace amalgam::protocol
