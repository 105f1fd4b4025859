#include "net/listener.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "net/address_key.h"
#include "net/say_and_close.h"
#include "protocol/limits.h"

namespace amalgam::net {

using boost::asio::ip::tcp;

Listener::Listener(boost::asio::io_context& io, const common::HostPort& address,
                   const ServerConfig& config, ConnectionLimits& limits, BackOff& back_off,
                   Metrics& metrics, Refusal refusal, OnAdmitted on_admitted)
    : config_(config),
      limits_(limits),
      back_off_(back_off),
      metrics_(metrics),
      refusal_(std::move(refusal)),
      on_admitted_(std::move(on_admitted)),
      accept_loop_(io, address, [this](tcp::socket socket) { judge(std::move(socket)); }) {}

void Listener::judge(tcp::socket socket) {
  boost::system::error_code ec;
  const tcp::endpoint peer = socket.remote_endpoint(ec);
  if (ec) return;  // gone already
  const auto& proxies = config_.trusted_proxies;
  const std::string address = unmapped(peer.address()).to_string();
  const bool by_proxy = std::find(proxies.begin(), proxies.end(), address) != proxies.end();
  const std::string key = address_key(peer.address());
  if (!by_proxy) {
    const auto left = back_off_.left(key, std::chrono::steady_clock::now());
    if (left.count() > 0) return refuse(socket, "back_off", left, "too many wrong tokens");
  }
  auto admitted = by_proxy ? limits_.admit_proxy(key) : limits_.admit(key);
  if (const auto* refusal = std::get_if<ConnectionLimits::Refusal>(&admitted)) {
    return refuse(socket, to_string(*refusal), protocol::kRetryAfter, "too many connections");
  }
  on_admitted_(
      {std::move(socket), std::get<ConnectionLimits::Ticket>(std::move(admitted)), by_proxy});
}

void Listener::refuse(tcp::socket& socket, const char* label, std::chrono::milliseconds retry_after,
                      const std::string& reason) {
  metrics_.refused(label);
  // A client that expects TLS would take a Busy for garbage; a close says as much.
  if (!config_.tls.certificate.empty()) return;
  say_and_close(socket, refusal_(retry_after, reason));
}

}  // namespace amalgam::net
