// Sessions with light of their own, with the real renderer behind a real server.
#include <gtest/gtest.h>

#include <future>
#include <optional>
#include <string>

#include "integration/real_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

constexpr int kWidth = 96, kHeight = 72;

TestClient session(RealServer& server) {
  return server.session(kWidth, kHeight);
}

std::string composite(TestClient& client, std::uint64_t id) {
  Envelope frame = frame_message(id, jpeg_of({kWidth, kHeight, common::Rgb8(128)}));
  frame.mutable_camera_frame()->clear_poses();
  *frame.mutable_camera_frame()->add_poses() =
      protocol::to_message(frame::default_pose(kMirrorWorldMarker));
  client.send(frame);
  return client.expect(Envelope::kComposite).composite().jpeg();
}

// The second frame of a server whose only environment this is.
std::string alone(const std::string& jpeg) {
  RealServer server;
  TestClient client = session(server);
  if (!jpeg.empty()) send_light(client, jpeg, false);
  composite(client, 1);
  return composite(client, 2);
}

void reload(frame::RenderThread& service) {
  std::promise<std::optional<std::string>> ended;
  service.replace_renderer(traced(),
                           [&](std::optional<std::string> error) { ended.set_value(error); });
  EXPECT_EQ(ended.get_future().get(), std::nullopt);
}

TEST(OwnEnvironment, EachSessionIsLitAsIfItWereAlone) {
  const std::string warm_alone = alone(kWarm), cold_alone = alone(kCold), scene_alone = alone("");
  ASSERT_FALSE(warm_alone == cold_alone);
  RealServer server;
  TestClient warm = session(server), cold = session(server), plain = session(server);
  send_light(warm, kWarm, true);
  send_light(cold, kCold, true);
  for (TestClient* client : {&warm, &cold, &plain}) composite(*client, 1);
  EXPECT_TRUE(composite(warm, 2) == warm_alone);
  EXPECT_TRUE(composite(cold, 2) == cold_alone);
  EXPECT_TRUE(composite(plain, 2) == scene_alone);

  // A new light for all is none for those who have their own. Exposures remember, so the follower
  // is a session that has seen no other light.
  send_light(plain, kCold, false);
  TestClient follower = session(server);
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
  TestClient client = session(server);
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
