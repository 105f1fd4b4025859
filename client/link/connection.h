// The client's connection to a server. Reconnects broken links, sends the newest frame and returns
// the answers.
//
// All functions are for one thread, the viewer's; the network has a thread of its own. Only wait()
// and the destructor block.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "common/host_port.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::client {

struct ConnectionOptions {
  common::HostPort server{"127.0.0.1", 7447};
  // Time for the first welcome, and for each reconnection. After it the connection gives up.
  std::chrono::milliseconds connect_timeout{5000};
  // An encoded Envelope to be sent after each welcome, before any frame; empty for none. After
  // each, because a restarted server needs it again.
  std::string after_welcome{};
  bool tls = false;
  // PEM file of the certificates that are trusted with TLS; empty: the system's.
  std::string certificate_authority{};
};

// Events, in the order in which they happened.
struct Welcomed {
  protocol::Welcome welcome;
};
struct Composited {  // of a frame that was sent, once
  protocol::Composite composite;
  std::chrono::steady_clock::time_point at;
};
struct FrameError {  // the session goes on
  protocol::Error error;
};
struct LinkBroken {  // being reconnected
  std::string text;
  std::uint64_t last_sent = 0;  // frames up to this id will not be answered
};
struct GaveUp {  // nothing more will come, not even for the frames that were sent
  std::string text;
};
using ConnectionEvent = std::variant<Welcomed, Composited, FrameError, LinkBroken, GaveUp>;

class Connection {
 public:
  // Starts connecting at once. Throws std::runtime_error if the certificates cannot be read.
  Connection(const ConnectionOptions& options, const protocol::Hello& hello);
  // Says goodbye, and waits up to a second for it to be received; for longer only while the
  // server's name is being resolved, which cannot be interrupted.
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // Queues a frame; ids ascend. Returns the id of the frame that it replaced, if any, which will
  // never be sent. bytes: an encoded Envelope.
  std::optional<std::uint64_t> send(std::uint64_t frame_id, std::string bytes);

  // The next event; waits for one up to the time-out.
  std::optional<ConnectionEvent> wait(std::chrono::milliseconds timeout);

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace amalgam::client
