// A real server with the real renderer behind it, for small pictures of the mirror scene.
#pragma once

#include <string>
#include <utility>

#include "codec/jpeg.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "frame/scene_renderer.h"
#include "protocol/geometry.h"
#include "support/net/server_around.h"

namespace amalgam::test {

inline const std::string kMirrorScene = AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf";
inline constexpr int kMirrorWorldMarker = 40;

inline std::string jpeg_of(const common::ImageRgb8& picture) {
  const frame::Bytes jpeg = codec::encode_jpeg(picture, 95);
  return {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()};
}

// An equirectangular environment, brighter on one side.
inline std::string light(const common::Rgb8& left, const common::Rgb8& right) {
  common::ImageRgb8 picture(64, 32, left);
  for (int y = 0; y < 32; ++y) {
    for (int x = 32; x < 64; ++x) picture.at(x, y) = right;
  }
  return jpeg_of(picture);
}
inline const std::string kWarm = light({250, 160, 60}, {60, 40, 20});
inline const std::string kCold = light({30, 40, 60}, {120, 180, 250});

inline void send_light(TestClient& client, const std::string& jpeg, bool own) {
  protocol::Envelope message = environment_message(jpeg);
  message.mutable_environment()->set_own(own);
  client.send(message);
}

// Without OpenGL, which takes seconds to start.
inline frame::MakeRenderer traced(const std::string& scene = kMirrorScene,
                                  frame::RendererSettings settings = {}) {
  settings.mode = frame::RendererMode::Raytrace;
  return frame::renderer_of_file(scene, settings);
}

// A busy machine refuses nobody here.
inline net::ServerConfig without_load(net::ServerConfig config = {}) {
  config.admission.load = 0.0;
  return config;
}

class RealServer {
 public:
  explicit RealServer(const frame::MakeRenderer& make = traced(),
                      const net::ServerConfig& config = {})
      : service(make), server(service, without_load(config)) {}

  frame::RenderThread service;
  ServerAround server;

  // Past its hello.
  TestClient session(int width, int height) {
    protocol::Envelope hello = hello_message();
    *hello.mutable_hello()->mutable_camera() =
        protocol::to_message(common::default_camera(width, height));
    return server.session(hello);
  }
};

}  // namespace amalgam::test
