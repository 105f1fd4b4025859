#include "net/tcp_options.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "net/server_config.h"
#include "protocol/limits.h"

namespace amalgam::net {

void set_tcp_options(boost::asio::ip::tcp::socket& socket, std::chrono::milliseconds user_timeout) {
  const auto set = [&](int option, int value) {
    ::setsockopt(socket.native_handle(), IPPROTO_TCP, option, &value, sizeof(value));
  };
  set(TCP_NODELAY, 1);
  set(TCP_USER_TIMEOUT, static_cast<int>(user_timeout.count()));
  set(TCP_NOTSENT_LOWAT, protocol::kUnsentBytes);
}

std::string peer_of(const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code ec;
  const auto endpoint = socket.remote_endpoint(ec);
  return ec ? "unknown" : to_string(HostPort{endpoint.address().to_string(), endpoint.port()});
}

}  // namespace amalgam::net
