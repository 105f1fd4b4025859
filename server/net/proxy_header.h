// The PROXY protocol, version 2 (haproxy.org, proxy-protocol.txt, section 2.2): what a trusted
// proxy says first about the client whose connection it forwards.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace amalgam::net {

struct ProxyHeader {
  // Nothing: the proxy speaks for itself (its health checks), or of no TCP over IP.
  std::optional<boost::asio::ip::tcp::endpoint> client;
  std::size_t bytes = 0;  // of the header; the client's own follow
};

struct ProxyNeedsMore {};
struct ProxyDefect {
  std::string what;
};

// The largest accepted header: addresses and a kilobyte of extensions.
inline constexpr std::size_t kMaxProxyHeaderBytes = 16 + 1024;

std::variant<ProxyHeader, ProxyNeedsMore, ProxyDefect> parse_proxy_header(
    std::span<const std::byte> input);

// Takes the header that has arrived at a socket, and nothing behind it. What is not complete stays
// where it is.
using ProxyRead = std::variant<ProxyHeader, ProxyNeedsMore, ProxyDefect, boost::system::error_code>;
ProxyRead take_proxy_header(boost::asio::ip::tcp::socket& socket);

}  // namespace amalgam::net
