// TCP options of both ends of a connection: small messages leave at once, a vanished peer is
// noticed, and the kernel does not buffer frames that newest-wins could still replace.
#pragma once

#include <chrono>

namespace amalgam::common {

struct TcpOptions {
  std::chrono::milliseconds user_timeout{0};  // without an acknowledgement for this long: broken
  int unsent_bytes = 0;                       // unsent bytes that the kernel may buffer
  int send_buffer_bytes = 0;  // unsent and unacknowledged ones; 0: the kernel's choice
};

// Best effort: ignores options that the kernel lacks. socket: a file descriptor.
void set_tcp_options(int socket, const TcpOptions& options);

// What was read is acknowledged at once. A peer that leaves its writes to Nagle's algorithm would
// otherwise keep a frame back until the Pong before it is acknowledged, 40 ms later. Holds for the
// last read only.
void acknowledge_now(int socket);

}  // namespace amalgam::common
