#include "client/tools/load/silent_client.h"

#include <boost/asio/buffer.hpp>
#include <chrono>
#include <span>

#include "protocol/limits.h"

namespace amalgam::load {
namespace {

namespace asio = boost::asio;

// Longer than a server waits for a hello.
constexpr std::chrono::seconds kPatience{20};

}  // namespace

SilentClient::SilentClient(asio::io_context& io, const LoadOptions& options, LoadSummary& summary)
    : options_(options),
      summary_(summary),
      stream_(asio::ip::tcp::socket(io)),
      timer_(io),
      buffer_(protocol::kReadBufferBytes) {}

void SilentClient::start(const std::optional<asio::ip::address>& source) {
  const asio::ip::tcp::endpoint server(asio::ip::make_address(options_.server.host),
                                       options_.server.port);
  if (source) {
    stream_.socket().open(server.protocol());
    stream_.socket().bind({*source, 0});
  }
  stream_.socket().async_connect(server, [self = shared_from_this()](const ErrorCode& ec) {
    ec ? self->end(true) : self->read();
  });
  timer_.expires_after(kPatience);
  timer_.async_wait([self = shared_from_this()](const ErrorCode& ec) {
    if (!ec) self->end(false);
  });
}

void SilentClient::read() {
  stream_.read_some(asio::buffer(buffer_),
                    [self = shared_from_this()](const ErrorCode& ec, std::size_t size) {
                      if (self->ended_) return;
                      if (ec) return self->end(true);
                      self->take(size);
                      if (!self->ended_) self->read();
                    });
}

void SilentClient::take(std::size_t size) {
  summary_.bytes_received += size;
  std::span<const std::byte> input = std::span(buffer_).first(size);
  const auto result = decoder_.next(input);
  const auto* const envelope = std::get_if<protocol::Envelope>(&result);
  if (envelope == nullptr) return;  // the rest comes, or the end
  if (envelope->has_busy()) ++summary_.errors["BUSY"];
  if (envelope->has_error()) {
    ++summary_.errors[protocol::Error::Code_Name(envelope->error().code())];
  }
  end(true);
}

void SilentClient::end(bool lost) {
  if (ended_) return;
  ended_ = true;
  if (lost) ++summary_.lost;
  stream_.close();
  timer_.cancel();
}

}  // namespace amalgam::load
