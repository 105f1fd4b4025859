#include "bench/scene_server.h"

#include "frame/render_thread.h"

namespace amalgam::bench {
namespace {

// Patient: a session says nothing, not even a pong, while the other side of a ratio is measured.
net::ServerConfig bench_config() {
  net::ServerConfig config;
  constexpr std::chrono::minutes kPatience{10};
  config.session.ping_interval = config.session.idle_timeout = kPatience;
  config.session.write_timeout = kPatience;
  config.listen.port = 0;
  config.admin.port = 0;
  return config;
}

}  // namespace

SceneServer::SceneServer(const std::filesystem::path& scene,
                         const frame::RendererSettings& settings)
    : service_(std::make_unique<frame::RenderThread>(
          scene.string(), frame::RenderServiceOptions{.renderer = settings})),
      server_(bench_config()) {
  server_.serve(*service_);
  network_ = std::thread([this] { server_.run(); });
}

SceneServer::~SceneServer() {
  server_.stop();
  network_.join();
}

}  // namespace amalgam::bench
