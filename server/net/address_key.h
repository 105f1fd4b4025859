// The part of an address that one party owns, by which connections and wrong tokens are counted.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string>

namespace amalgam::net {

// An IPv4 address (mapped into IPv6 or not) as a whole; of IPv6 the /64 that a household gets.
inline std::string address_key(const boost::asio::ip::address& address) {
  namespace ip = boost::asio::ip;
  if (address.is_v4()) return address.to_string();
  const ip::address_v6 v6 = address.to_v6();
  if (v6.is_v4_mapped()) return ip::make_address_v4(ip::v4_mapped, v6).to_string();
  ip::address_v6::bytes_type bytes = v6.to_bytes();
  for (std::size_t i = 8; i < bytes.size(); ++i) bytes[i] = 0;
  return ip::address_v6(bytes).to_string() + "/64";
}

}  // namespace amalgam::net
