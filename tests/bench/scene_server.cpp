#include "bench/scene_server.h"

#include "frame/render_thread.h"

namespace amalgam::bench {
namespace {

net::ServerConfig free_ports() {
  net::ServerConfig config;
  config.listen.port = 0;
  config.admin.port = 0;
  return config;
}

}  // namespace

SceneServer::SceneServer(const std::filesystem::path& scene,
                         const frame::RendererSettings& settings)
    : service_(frame::make_render_service(scene.string(), {.renderer = settings})),
      server_(free_ports()) {
  server_.serve(*service_);
  network_ = std::thread([this] { server_.run(); });
}

SceneServer::~SceneServer() {
  server_.stop();
  network_.join();
}

}  // namespace amalgam::bench
