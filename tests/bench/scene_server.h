// The whole server in this process, for one scene, on a free port of the loopback.
#pragma once

#include <filesystem>
#include <memory>
#include <thread>

#include "frame/renderer_settings.h"
#include "net/server.h"

namespace amalgam::bench {

class SceneServer {
 public:
  // Returns when clients may connect. Throws what loading or listening throws.
  SceneServer(const std::filesystem::path& scene, const frame::RendererSettings& settings);
  ~SceneServer();

  common::HostPort address() const { return server_.address(); }

 private:
  std::unique_ptr<frame::FrameService> service_;  // outlives the server, which uses it
  net::Server server_;
  std::thread network_;
};

}  // namespace amalgam::bench
