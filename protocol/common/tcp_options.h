// Kernel options of both ends of a connection: small messages leave at once, a vanished peer is
// noticed, and the kernel does not hoard frames that newest-wins could still replace.
#pragma once

#include <chrono>

namespace amalgam::common {

struct TcpOptions {
  std::chrono::milliseconds user_timeout{0};  // without an acknowledgement for so long: broken
  int unsent_bytes = 0;                       // that the kernel may hold
};

// Best effort: a kernel without one of them still serves. socket: a file descriptor.
void set_tcp_options(int socket, const TcpOptions& options);

}  // namespace amalgam::common
