#include "net/tcp_transport.h"

#include <utility>

namespace amalgam::net {

TcpTransport::TcpTransport(boost::asio::ip::tcp::socket socket, TlsContext tls)
    : stream_(std::move(socket)), tls_(std::move(tls)) {}

void TcpTransport::open(OnOpened done, OnServed /*nothing else is served*/) {
  if (!tls_) return done(ErrorCode(), Opened::Session);
  stream_.handshake_as_server(
      tls_, [done = std::move(done)](const ErrorCode& ec) { done(ec, Opened::Session); });
}

void TcpTransport::read(boost::asio::mutable_buffer buffer, OnReceived done) {
  stream_.read_some(buffer, [done = std::move(done)](const ErrorCode& ec, std::size_t size) {
    done(ec, {.size = size, .part = std::nullopt, .defect = nullptr});
  });
}

void TcpTransport::write(boost::asio::const_buffer envelopes, OnSize done) {
  stream_.write(envelopes, std::move(done));
}

}  // namespace amalgam::net
