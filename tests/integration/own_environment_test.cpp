// Sessions with light of their own, with the real renderer behind a real server.
#include <gtest/gtest.h>

#include <future>
#include <optional>
#include <string>

#include "codec/jpeg.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "frame/scene_renderer.h"
#include "protocol/geometry.h"
#include "support/net/server_around.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

constexpr int kWidth = 96, kHeight = 72;
const std::string kScene = AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf";

std::string jpeg_of(const common::ImageRgb8& picture) {
  const frame::Bytes jpeg = codec::encode_jpeg(picture, 95);
  return {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()};
}

// Equirectangular, brighter on one side.
std::string light(const common::Rgb8& left, const common::Rgb8& right) {
  common::ImageRgb8 picture(64, 32, left);
  for (int y = 0; y < 32; ++y) {
    for (int x = 32; x < 64; ++x) picture.at(x, y) = right;
  }
  return jpeg_of(picture);
}
const std::string kWarm = light({250, 160, 60}, {60, 40, 20});
const std::string kCold = light({30, 40, 60}, {120, 180, 250});

// Without OpenGL, which takes seconds to start; tests/unit/frame has the same with it.
frame::MakeRenderer renderer() {
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  return frame::renderer_of_file(kScene, settings);
}

// A busy machine refuses nobody here.
net::ServerConfig config_without_load() {
  net::ServerConfig config;
  config.admission.load = 0.0;
  return config;
}

class RealServer {
 public:
  frame::RenderThread service{renderer()};
  ServerAround server{service, config_without_load()};

  TestClient session() {
    Envelope hello = hello_message();
    *hello.mutable_hello()->mutable_camera() =
        protocol::to_message(common::default_camera(kWidth, kHeight));
    return server.session(hello);
  }
};

void send_light(TestClient& client, const std::string& jpeg, bool own) {
  Envelope message = environment_message(jpeg);
  message.mutable_environment()->set_own(own);
  client.send(message);
}

std::string composite(TestClient& client, std::uint64_t id) {
  Envelope frame = frame_message(id, jpeg_of({kWidth, kHeight, common::Rgb8(128)}));
  frame.mutable_camera_frame()->clear_poses();
  *frame.mutable_camera_frame()->add_poses() = protocol::to_message(frame::default_pose(40));
  client.send(frame);
  return client.expect(Envelope::kComposite).composite().jpeg();
}

// The second frame of a server whose only environment this is.
std::string alone(const std::string& jpeg) {
  RealServer server;
  TestClient client = server.session();
  if (!jpeg.empty()) send_light(client, jpeg, false);
  composite(client, 1);
  return composite(client, 2);
}

void reload(frame::RenderThread& service) {
  std::promise<std::optional<std::string>> ended;
  service.replace_renderer(renderer(),
                           [&](std::optional<std::string> error) { ended.set_value(error); });
  EXPECT_EQ(ended.get_future().get(), std::nullopt);
}

TEST(OwnEnvironment, EachSessionIsLitAsIfItWereAlone) {
  const std::string warm_alone = alone(kWarm), cold_alone = alone(kCold), scene_alone = alone("");
  ASSERT_FALSE(warm_alone == cold_alone);
  RealServer server;
  TestClient warm = server.session(), cold = server.session(), plain = server.session();
  send_light(warm, kWarm, true);
  send_light(cold, kCold, true);
  for (TestClient* client : {&warm, &cold, &plain}) composite(*client, 1);
  EXPECT_TRUE(composite(warm, 2) == warm_alone);
  EXPECT_TRUE(composite(cold, 2) == cold_alone);
  EXPECT_TRUE(composite(plain, 2) == scene_alone);

  // A new light for all is none for those who have their own. Exposures remember, so the follower
  // is a session that has seen no other light.
  send_light(plain, kCold, false);
  TestClient follower = server.session();
  composite(follower, 1);
  EXPECT_TRUE(composite(follower, 2) == cold_alone);
  EXPECT_TRUE(composite(warm, 3) == warm_alone);

  // A reload brings the scene's light back, and every session keeps its own. States are new.
  reload(server.service);
  for (TestClient* client : {&warm, &follower}) composite(*client, 4);
  EXPECT_TRUE(composite(warm, 5) == warm_alone);
  EXPECT_TRUE(composite(follower, 5) == scene_alone);
}

// It is looked at with the next frame; the session goes on with the light that it had.
TEST(OwnEnvironment, AnUnusableOneIsTold) {
  RealServer server;
  TestClient client = server.session();
  const std::string before = composite(client, 1);
  send_light(client, "no JPEG", true);
  Envelope frame = frame_message(2, jpeg_of({kWidth, kHeight, common::Rgb8(128)}));
  client.send(frame);
  client.expect_error(protocol::Error::BAD_ENVIRONMENT);
  client.expect(Envelope::kComposite);
  EXPECT_TRUE(composite(client, 3) == before);
}

}  // namespace
}  // namespace amalgam::test
