// The whole network side: listener, sessions, admin port, signals and shutdown. One thread calls
// run() and is the network thread; the other functions may be called from any thread.
#pragma once

#include <memory>

#include "frame/frame.h"
#include "net/server_config.h"

namespace amalgam::net {

class Server {
 public:
  // Binds both addresses. Once run() is called the admin port answers, not ready yet. Throws
  // std::runtime_error if an address cannot be bound.
  explicit Server(const ServerConfig& config);
  ~Server();

  // Clients may connect as soon as this returns. Call it once, before drain() or stop(). Throws
  // std::runtime_error. The service must outlive the Server.
  void serve(frame::FrameService& service);

  // Returns when the server has ended.
  void run();

  // SIGTERM and SIGINT drain. A second one, or one before serve(), exits the process.
  void drain_on_signals();

  // Not ready from now on; sends Draining to clients and finishes frames in flight. Then run()
  // returns, after ServerConfig::drain_timeout at the latest.
  void drain();
  // Ends without finishing frames.
  void stop();

  common::HostPort address() const;
  common::HostPort admin_address() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::net
