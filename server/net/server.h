// The network side as a whole: listener, sessions, admin port, signals and a clean end. One thread
// calls run() and is the network thread; the other functions may be called from any thread.
#pragma once

#include <memory>

#include "frame/frame.h"
#include "net/server_config.h"

namespace amalgam::net {

class Server {
 public:
  // Takes both addresses and answers on the admin port, not ready yet, once run() is called. Throws
  // std::runtime_error if an address cannot be had.
  explicit Server(const ServerConfig& config);
  ~Server();

  // Clients may connect as soon as this returns. Once only, and before drain() or stop(). Throws
  // std::runtime_error. The service must outlive the Server.
  void serve(frame::FrameService& service);

  // Returns when the server has ended.
  void run();

  // SIGTERM and SIGINT drain; a second one, or one while nothing is served yet, exits the process.
  void drain_on_signals();

  // Not ready at once, Draining to clients, frames in flight are finished; then run() returns,
  // after ServerConfig::drain_timeout at the latest.
  void drain();
  // The same without finishing anything.
  void stop();

  common::HostPort address() const;
  common::HostPort admin_address() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::net
