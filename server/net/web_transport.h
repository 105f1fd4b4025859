// The web port's connections: HTTP first, which answers with a file of the page or turns into
// WebSocket, one Envelope a binary message.
#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <optional>

#include "net/beast_stream.h"
#include "net/made_files.h"
#include "net/server_config.h"
#include "net/tls.h"
#include "net/transport.h"
#include "net/web_request.h"

namespace amalgam::net {

class WebTransport final : public Transport {
 public:
  // tls: null, or what to encrypt with. options and made outlive the transport.
  WebTransport(boost::asio::ip::tcp::socket socket, TlsContext tls, const WebOptions& options,
               MadeFiles& made);

  void open(OnOpened done, OnServed served) override;
  void read(boost::asio::mutable_buffer buffer, OnReceived done) override;
  void write(boost::asio::const_buffer envelopes, OnSize done) override;
  void finish_sending() override;
  void close() override { stream_.close(); }
  boost::asio::ip::tcp::socket& socket() override { return stream_.socket(); }
  bool encrypted() const override { return tls_ != nullptr; }
  bool speaks_at_once() const override { return false; }
  const char* name() const override { return "websocket"; }

 private:
  void read_request(OnOpened done, OnServed served);
  void on_request(const ErrorCode& ec, OnOpened done, OnServed served);
  void upgrade(OnOpened done);
  void say(WebAnswer answer, OnOpened done, OnServed served);
  void write_answer(std::string_view rest, OnOpened done, OnServed served);
  void write_next(OnSize done);
  Received received(std::size_t size);

  protocol::Stream stream_;
  BeastStream http_{stream_};
  TlsContext tls_;
  const WebOptions& options_;
  MadeFiles& made_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>> parser_;
  WebAnswer answer_;
  // Without compression: JPEGs do not shrink.
  std::optional<boost::beast::websocket::stream<BeastStream, false>> socket_;
  bool finished_ = false;
  boost::asio::const_buffer unwritten_;
  std::size_t written_ = 0;
};

}  // namespace amalgam::net
