#include "net/web_transport.h"

#include <algorithm>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

namespace {

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;  // browsers stay below
// Of a file; after each the client has its time anew.
constexpr std::size_t kPieceBytes = 64 * 1024;

// A step between two of the connection's, which guards only its own: what is thrown ends it.
template <typename Done, typename Step>
void guarded(const Done& failed, Step step) {
  try {
    step();
  } catch (const std::exception&) {
    failed(boost::system::errc::make_error_code(boost::system::errc::not_enough_memory));
  }
}

bool is_gone(const boost::system::error_code& ec) {
  return ec == http::error::end_of_stream || ec == http::error::partial_message ||
         ec.category() != http::make_error_code(http::error::end_of_stream).category();
}

}  // namespace

WebTransport::WebTransport(asio::ip::tcp::socket socket, TlsContext tls, const WebOptions& options,
                           MadeFiles& made)
    : stream_(std::move(socket)),
      tls_(std::move(tls)),
      options_(options),
      made_(made),
      buffer_(kMaxHeaderBytes + kPieceBytes) {}

// --- before the session ---

void WebTransport::open(OnOpened done, OnServed served) {
  if (!tls_) return read_request(std::move(done), std::move(served));
  stream_.handshake_as_server(tls_, [this, done, served](const ErrorCode& ec) {
    if (ec) return done(ec, Opened::Nothing);
    guarded([&](const ErrorCode& thrown) { done(thrown, Opened::Nothing); },
            [&] { read_request(done, served); });
  });
}

void WebTransport::read_request(OnOpened done, OnServed served) {
  parser_.emplace();
  parser_->header_limit(kMaxHeaderBytes);
  http::async_read_header(http_, buffer_, *parser_,
                          [this, done, served](const ErrorCode& ec, std::size_t) {
                            guarded([&](const ErrorCode& thrown) { done(thrown, Opened::Nothing); },
                                    [&] { on_request(ec, done, served); });
                          });
}

void WebTransport::on_request(const ErrorCode& ec, OnOpened done, OnServed served) {
  if (ec && is_gone(ec)) return done(ec, Opened::Nothing);
  if (ec) {
    return say(answer_to_garbage(ec == http::error::header_limit, ec.message()), std::move(done),
               std::move(served));
  }
  auto judged = judge(parser_->get(), options_);
  if (const auto* file = std::get_if<MadeFile>(&judged)) {
    // Whoever has gone meanwhile is noticed when the answer is written; done keeps this alive.
    return made_.get(file->target, options_.made.find(file->target)->second,
                     [this, done, served](const MadeFiles::Result& result) {
                       guarded([&](const ErrorCode& thrown) { done(thrown, Opened::Nothing); },
                               [&] { say(answer_with(parser_->get(), result), done, served); });
                     });
  }
  const bool upgrades = std::holds_alternative<Upgrade>(judged);
  if (upgrades && buffer_.size() == 0) return upgrade(std::move(done));
  // WebSocket's frames may come only after the answer.
  say(upgrades ? answer_to_garbage(false, "something came behind the request")
               : std::get<WebAnswer>(std::move(judged)),
      std::move(done), std::move(served));
}

void WebTransport::say(WebAnswer answer, OnOpened done, OnServed served) {
  answer_ = std::move(answer);
  asio::const_buffer head = asio::buffer(answer_.head);
  stream_.write(head, [this, done, served](const ErrorCode& failed, std::size_t) {
    if (failed) return done(failed, Opened::Nothing);
    guarded([&](const ErrorCode& thrown) { done(thrown, Opened::Nothing); },
            [&] { write_answer(answer_.page.bytes(), done, served); });
  });
}

void WebTransport::write_answer(std::string_view rest, OnOpened done, OnServed served) {
  if (rest.empty()) return done(ErrorCode(), Opened::Nothing);
  const std::string_view piece = rest.substr(0, kPieceBytes);
  stream_.write(asio::buffer(piece), [this, rest = rest.substr(piece.size()), done, served](
                                         const ErrorCode& ec, std::size_t) {
    if (ec) return done(ec, Opened::Nothing);
    served();
    guarded([&](const ErrorCode& thrown) { done(thrown, Opened::Nothing); },
            [&] { write_answer(rest, done, served); });
  });
}

void WebTransport::upgrade(OnOpened done) {
  socket_.emplace(stream_);
  // Deadlines and sizes are the connection's.
  socket_->set_option(websocket::stream_base::timeout{websocket::stream_base::none(),
                                                      websocket::stream_base::none(), false});
  socket_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.erase(http::field::server);  // nobody's business
  }));
  socket_->read_message_max(0);
  socket_->auto_fragment(false);
  socket_->binary(true);
  socket_->async_accept(parser_->get(), [this, done](const ErrorCode& ec) {
    parser_.reset();
    done(ec, ec ? Opened::Nothing : Opened::Session);
  });
}

// --- the session ---

void WebTransport::read(asio::mutable_buffer buffer, OnReceived done) {
  if (!socket_) {
    return stream_.read_some(buffer, [done](const ErrorCode& ec, std::size_t size) {
      done(ec, {.size = size, .part = std::nullopt, .defect = nullptr});
    });
  }
  socket_->async_read_some(buffer, [this, done](const ErrorCode& ec, std::size_t size) {
    done(ec, ec ? Received() : received(size));
  });
}

// What Beast knows of the message: the frame's length, before any of it is kept.
Transport::Received WebTransport::received(std::size_t size) {
  Received received;
  received.size = size;
  const bool last = socket_->is_message_done();
  received.part =
      protocol::Decoder::Part{.at_least_left = last ? 0 : socket_->read_size_hint(1), .last = last};
  if (socket_->got_text()) received.defect = "a text message, where Envelopes are binary";
  return received;
}

void WebTransport::write(asio::const_buffer envelopes, OnSize done) {
  unwritten_ = envelopes;
  written_ = 0;
  write_next(std::move(done));
}

// A message for each Envelope, without its length.
void WebTransport::write_next(OnSize done) {
  const auto* bytes = static_cast<const unsigned char*>(unwritten_.data());
  std::size_t length = 0;
  for (std::size_t i = 0; i < protocol::kLengthBytes; ++i) {
    length |= static_cast<std::size_t>(bytes[i]) << (8 * i);
  }
  const asio::const_buffer message = asio::buffer(unwritten_ + protocol::kLengthBytes, length);
  unwritten_ += protocol::kLengthBytes + length;
  written_ += protocol::kLengthBytes + length;
  socket_->async_write(message, [this, done](const ErrorCode& ec, std::size_t) {
    if (ec || unwritten_.size() == 0) return done(ec, written_);
    guarded([&](const ErrorCode& thrown) { done(thrown, 0); }, [&] { write_next(done); });
  });
}

// WebSocket's own farewell, which browsers wait for. Beast answers one of theirs by itself.
void WebTransport::finish_sending() {
  if (std::exchange(finished_, true)) return;
  if (!socket_ || !socket_->is_open()) return stream_.finish_sending();
  socket_->async_close(websocket::close_code::normal, [](const ErrorCode&) {});
}

}  // namespace amalgam::net
