// A network address as text, one grammar for all programs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace amalgam::common {

struct HostPort {
  std::string host;  // a name, or a numeric IPv4 or IPv6 address without brackets
  std::uint16_t port = 0;
  bool operator==(const HostPort&) const = default;
};

// "127.0.0.1:7447", "[::1]:7447" or "desk.example:7447". Throws std::invalid_argument for anything
// else, such as an IPv6 address without brackets.
HostPort parse_host_port(std::string_view text);
std::string to_string(const HostPort& address);

}  // namespace amalgam::common
