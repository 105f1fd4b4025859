// The whole network side: listener, sessions, admin port, signals and shutdown. One thread calls
// run() and is the network thread; the other functions may be called from any thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "frame/frame.h"
#include "net/server_config.h"
#include "net/tls.h"

namespace amalgam::net {

class Server {
 public:
  // Binds all addresses. Once run() is called the admin port answers, not ready yet. Throws
  // std::runtime_error if an address cannot be bound or a certificate not be used.
  explicit Server(const ServerConfig& config);
  ~Server();

  // Clients may connect as soon as this returns. Call it once, before drain() or stop(). Throws
  // std::runtime_error. The service must outlive the Server.
  void serve(frame::FrameService& service);

  // Returns when the server has ended.
  void run();

  // SIGTERM and SIGINT drain. A second one, or one before serve(), exits the process. SIGHUP calls
  // reload on the network thread; while loading or draining nothing happens.
  void handle_signals(std::function<void()> reload);

  // Runs a step on the network thread.
  void post(std::function<void()> step);

  // Takes over what may change while sessions are open: tokens and rights, limits, certificates,
  // trusted proxies. Sessions keep what they were promised; addresses stay. tls: of config.tls. On
  // the network thread only.
  void configure(const ServerConfig& config, TlsContext tls);
  // How a reload ended; nothing: well.
  void reload_ended(const std::optional<std::string>& error);

  // Not ready from now on. After ServerConfig::drain_delay sends Draining to clients and finishes
  // frames in flight. Then run() returns, after ServerConfig::drain_timeout at the latest.
  void drain();
  // Ends without finishing frames.
  void stop();

  common::HostPort address() const;
  common::HostPort admin_address() const;
  std::optional<common::HostPort> agent_address() const;
  std::optional<common::HostPort> web_address() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::net
