#include "common/tcp_options.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace amalgam::common {

void set_tcp_options(int socket, const TcpOptions& options) {
  const auto set = [&](int option, int value) {
    ::setsockopt(socket, IPPROTO_TCP, option, &value, sizeof(value));
  };
  set(TCP_NODELAY, 1);
  set(TCP_USER_TIMEOUT, static_cast<int>(options.user_timeout.count()));
  set(TCP_NOTSENT_LOWAT, options.unsent_bytes);
  if (const int bytes = options.send_buffer_bytes; bytes > 0) {
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof(bytes));
  }
}

void acknowledge_now(int socket) {
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_QUICKACK, &on, sizeof(on));
}

}  // namespace amalgam::common
