// Addresses as text: whole for logs, and the part that one party owns, by which connections and
// wrong tokens are counted.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <string>

#include "common/host_port.h"

namespace amalgam::net {

// The IPv4 address that is mapped into an IPv6 one, if there is one.
inline boost::asio::ip::address unmapped(const boost::asio::ip::address& address) {
  namespace ip = boost::asio::ip;
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
  return ip::make_address_v4(ip::v4_mapped, address.to_v6());
}

// An IPv4 address (mapped into IPv6 or not) as a whole; of IPv6 the /64 that a household gets.
inline std::string address_key(const boost::asio::ip::address& address) {
  namespace ip = boost::asio::ip;
  const ip::address plain = unmapped(address);
  if (plain.is_v4()) return plain.to_string();
  ip::address_v6::bytes_type bytes = plain.to_v6().to_bytes();
  for (std::size_t i = 8; i < bytes.size(); ++i) bytes[i] = 0;
  return ip::address_v6(bytes).to_string() + "/64";
}

// For logs.
inline std::string text_of(const boost::asio::ip::tcp::endpoint& endpoint) {
  return to_string(common::HostPort{endpoint.address().to_string(), endpoint.port()});
}

}  // namespace amalgam::net
