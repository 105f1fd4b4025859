#include "support/net/web_wire.h"

#include <unistd.h>

#include <array>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/http/field.hpp>
#include <stdexcept>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::test {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

// Of every frame; anything but 0, so that it is noticed if nobody takes it off.
constexpr std::array<unsigned char, 4> kMask{0x5a, 0xc3, 0x96, 0x0f};

asio::ip::tcp::socket adopted(asio::io_context& io, int handle) {
  return {io, asio::ip::tcp::v4(), ::dup(handle)};
}

// A binary message of so many bytes in one frame (RFC 6455, 5.2).
std::string frame_head(std::size_t length) {
  // The shortest form is the only one that is allowed.
  const int bytes = length < 126 ? 0 : length < 65536 ? 2 : 8;
  std::string head{'\x82', static_cast<char>(bytes == 0   ? 0x80 | length
                                             : bytes == 2 ? 0x80 | 126
                                                          : 0x80 | 127)};
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
    head += static_cast<char>((length >> shift) & 0xff);
  }
  for (const unsigned char byte : kMask) head += static_cast<char>(byte);
  return head;
}

}  // namespace

WebWire::WebWire(int handle, const common::HostPort& server, const std::string& origin,
                 protocol::Stream::Tls tls)
    : stream_(adopted(io_, handle)), socket_(stream_) {
  error_code ec;
  if (tls) {
    ec = wait([&](auto done) { stream_.handshake_as_client(std::move(tls), server.host, done); });
  }
  if (ec) throw std::runtime_error("no TLS: " + ec.message());
  socket_.read_message_max(protocol::kMaxCompositeBytes);
  if (!origin.empty()) {
    socket_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      request.set(boost::beast::http::field::origin, origin);
    }));
  }
  ec = wait([&](auto done) { socket_.async_handshake(to_string(server), "/session", done); });
  if (ec) throw std::runtime_error("no WebSocket: " + ec.message());
}

std::optional<std::string> WebWire::read() {
  buffer_.clear();
  const error_code ec = wait([&](auto done) {
    socket_.async_read(buffer_, [done](const error_code& failed, std::size_t) { done(failed); });
  });
  if (ec) return std::nullopt;
  return boost::beast::buffers_to_string(buffer_.data());
}

bool WebWire::write(const std::string& message) {
  socket_.binary(true);
  return !wait([&](auto done) {
    socket_.async_write(asio::buffer(message),
                        [done](const error_code& failed, std::size_t) { done(failed); });
  });
}

std::string WebWire::frames_of(std::string_view stream) {
  std::string frames;
  for (const char byte : stream) {
    if (length_bytes_ < protocol::kLengthBytes) {
      length_ |= std::size_t{static_cast<unsigned char>(byte)} << (8 * length_bytes_);
      if (++length_bytes_ == protocol::kLengthBytes) frames += frame_head(length_);
    } else {
      frames += static_cast<char>(static_cast<unsigned char>(byte) ^ kMask[sent_ % kMask.size()]);
      ++sent_;
    }
    if (length_bytes_ == protocol::kLengthBytes && sent_ == length_) {
      length_bytes_ = length_ = sent_ = 0;
    }
  }
  return frames;
}

template <typename Begin>
error_code WebWire::wait(Begin begin) {
  std::optional<error_code> result;
  begin([&](const error_code& ec) { result = ec; });
  io_.restart();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!result && io_.run_one_until(end) > 0) {
  }
  if (!result) throw std::runtime_error("nothing came for ten seconds");
  return *result;
}

}  // namespace amalgam::test
