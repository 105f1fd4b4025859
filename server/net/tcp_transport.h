// Envelopes over TCP, or over TLS 1.3, each behind its length.
#pragma once

#include "net/tls.h"
#include "net/transport.h"
#include "protocol/stream.h"

namespace amalgam::net {

class TcpTransport final : public Transport {
 public:
  // tls: null, or what to encrypt with.
  TcpTransport(boost::asio::ip::tcp::socket socket, TlsContext tls);

  void open(OnOpened done, OnServed served) override;
  void read(boost::asio::mutable_buffer buffer, OnReceived done) override;
  void write(boost::asio::const_buffer envelopes, OnSize done) override;
  void finish_sending() override { stream_.finish_sending(); }
  void close() override { stream_.close(); }
  boost::asio::ip::tcp::socket& socket() override { return stream_.socket(); }
  bool encrypted() const override { return tls_ != nullptr; }
  bool speaks_at_once() const override { return !encrypted(); }
  const char* name() const override { return "tcp"; }

 private:
  protocol::Stream stream_;
  TlsContext tls_;
};

}  // namespace amalgam::net
