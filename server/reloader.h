// What SIGHUP does: reads options and scene again and takes both over, or neither.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "frame/render_thread.h"
#include "net/server.h"
#include "net/tls.h"
#include "server/server_options.h"

namespace amalgam {

// Reads the command line and its configuration file once more. Throws with one line.
using ReloadOptions = std::function<ServerOptions()>;

class Reloader {
 public:
  // Both outlive it.
  Reloader(net::Server& server, frame::RenderThread& service, ReloadOptions options)
      : server_(server), service_(service), options_(std::move(options)) {}

  // On the network thread. The scene is loaded on a thread of its own, so that nobody waits for the
  // disk. The renderer changes between two frames, and with it the configuration. Asked again while
  // it loads, it loads once more when that is done.
  void reload();

 private:
  using Tls = net::TlsContext;
  void load(const ServerOptions& options, const Tls& tls);
  void ended(const std::optional<std::string>& error);  // on the network thread

  net::Server& server_;
  frame::RenderThread& service_;
  ReloadOptions options_;
  bool busy_ = false, again_ = false;  // used on the network thread
  std::jthread loading_;
};

}  // namespace amalgam
