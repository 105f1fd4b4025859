#include "net/listener.h"

#include <boost/asio/buffer.hpp>
#include <utility>
#include <variant>

#include "protocol/framing.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

using boost::asio::ip::tcp;

std::string encoded_busy() {
  protocol::Envelope envelope;
  protocol::Busy& busy = *envelope.mutable_busy();
  busy.set_retry_after_ms(static_cast<std::uint32_t>(protocol::kRetryAfter.count()));
  busy.set_reason("too many connections");
  return protocol::encode(envelope);
}

// Best effort, without waiting: a few bytes fit the buffer of a new socket.
void say_and_close(tcp::socket& socket, const std::string& bytes) {
  boost::system::error_code ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(boost::asio::buffer(bytes), ignored);
  socket.shutdown(tcp::socket::shutdown_send, ignored);
  socket.close(ignored);
}

}  // namespace

Listener::Listener(boost::asio::io_context& io, const common::HostPort& address,
                   ConnectionLimits& limits, Metrics& metrics, OnAdmitted on_admitted)
    : limits_(limits),
      metrics_(metrics),
      on_admitted_(std::move(on_admitted)),
      busy_(encoded_busy()),
      accept_loop_(io, address, [this](tcp::socket socket) { judge(std::move(socket)); }) {}

void Listener::judge(tcp::socket socket) {
  boost::system::error_code ec;
  const tcp::endpoint peer = socket.remote_endpoint(ec);
  if (ec) return;  // gone already
  auto admitted = limits_.admit(peer.address().to_string());
  if (const auto* refusal = std::get_if<ConnectionLimits::Refusal>(&admitted)) {
    metrics_.refused(to_string(*refusal));
    return say_and_close(socket, busy_);
  }
  on_admitted_(std::move(socket), std::get<ConnectionLimits::Ticket>(std::move(admitted)));
}

}  // namespace amalgam::net
