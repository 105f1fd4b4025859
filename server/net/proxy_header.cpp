#include "net/proxy_header.h"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/read.hpp>
#include <cstdint>

namespace amalgam::net {
namespace {

namespace ip = boost::asio::ip;

constexpr std::array<unsigned char, 12> kSignature{0x0d, 0x0a, 0x0d, 0x0a, 0x00, 0x0d,
                                                   0x0a, 0x51, 0x55, 0x49, 0x54, 0x0a};
constexpr std::size_t kFixed = 16;  // signature, version and command, family, length
constexpr unsigned kLocal = 0x20, kProxy = 0x21;
constexpr unsigned kTcp4 = 0x11, kTcp6 = 0x21;

unsigned at(std::span<const std::byte> input, std::size_t i) {
  return std::to_integer<unsigned>(input[i]);
}

std::uint16_t big_endian(std::span<const std::byte> input, std::size_t i) {
  return static_cast<std::uint16_t>((at(input, i) << 8) | at(input, i + 1));
}

template <typename Address>
Address address_at(std::span<const std::byte> input, std::size_t begin) {
  typename Address::bytes_type bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<unsigned char>(at(input, begin + i));
  }
  return Address(bytes);
}

}  // namespace

std::variant<ProxyHeader, ProxyNeedsMore, ProxyDefect> parse_proxy_header(
    std::span<const std::byte> input) {
  for (std::size_t i = 0; i < std::min(input.size(), kSignature.size()); ++i) {
    if (at(input, i) != kSignature[i]) return ProxyDefect{"no PROXY header of version 2"};
  }
  if (input.size() < kFixed) return ProxyNeedsMore{};
  const unsigned command = at(input, 12);
  if (command != kLocal && command != kProxy) return ProxyDefect{"an unknown PROXY command"};
  const std::size_t length = big_endian(input, 14);
  if (kFixed + length > kMaxProxyHeaderBytes) return ProxyDefect{"a PROXY header that is too long"};
  if (input.size() < kFixed + length) return ProxyNeedsMore{};
  ProxyHeader header{std::nullopt, kFixed + length};
  if (command == kLocal) return header;
  // Source and destination address, source and destination port.
  const unsigned family = at(input, 13);
  if (family == kTcp4) {
    if (length < 12) return ProxyDefect{"a PROXY header without its addresses"};
    header.client.emplace(address_at<ip::address_v4>(input, kFixed), big_endian(input, kFixed + 8));
  } else if (family == kTcp6) {
    if (length < 36) return ProxyDefect{"a PROXY header without its addresses"};
    header.client.emplace(address_at<ip::address_v6>(input, kFixed),
                          big_endian(input, kFixed + 32));
  }
  return header;
}

ProxyRead take_proxy_header(ip::tcp::socket& socket) {
  boost::system::error_code ec;
  std::array<std::byte, kMaxProxyHeaderBytes> bytes;
  const std::size_t size =
      socket.receive(boost::asio::buffer(bytes), ip::tcp::socket::message_peek, ec);
  if (ec) return ec;
  const auto parsed = parse_proxy_header(std::span(bytes).first(size));
  if (const auto* header = std::get_if<ProxyHeader>(&parsed)) {
    boost::asio::read(socket, boost::asio::buffer(bytes, header->bytes), ec);
    if (ec) return ec;
  }
  return std::visit([](const auto& result) -> ProxyRead { return result; }, parsed);
}

}  // namespace amalgam::net
