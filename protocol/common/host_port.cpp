#include "common/host_port.h"

#include <charconv>
#include <stdexcept>

namespace amalgam::common {

HostPort parse_host_port(std::string_view text) {
  const auto fail = [&]() -> HostPort {
    throw std::invalid_argument("'" + std::string(text) +
                                "' is not ADDRESS:PORT, as 127.0.0.1:7447 or [::1]:7447");
  };
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return fail();
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = text.substr(colon + 1);
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    return fail();
  }
  std::uint16_t port = 0;
  const char* const end = digits.data() + digits.size();
  const auto [parsed_to, error] = std::from_chars(digits.data(), end, port);
  if (host.empty() || error != std::errc() || parsed_to != end) return fail();
  return {std::string(host), port};
}

std::string to_string(const HostPort& address) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return (v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace amalgam::common
