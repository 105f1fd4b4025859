// An environment sent by a client while the server is running.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using testing::HasSubstr;

TEST(Environment, ReachesTheRendererAndNobodyIsTold) {
  TestServer server;
  TestClient client = server.session();
  client.send(environment_message("a hall"));
  ASSERT_TRUE(server.service.wait_environments(1));
  const frame::EnvironmentInput input = server.service.environments().front();
  EXPECT_EQ(input.image.size(), 6u);
  EXPECT_EQ(input.projection, frame::EnvironmentInput::Projection::Equirectangular);

  Envelope fisheye = environment_message("the sky");
  protocol::Fisheye& lens = *fisheye.mutable_environment()->mutable_fisheye();
  lens.set_width(1000);
  lens.set_height(1000);
  lens.set_fx(300);
  lens.set_fy(300);
  lens.set_cx(499.5);
  lens.set_cy(499.5);
  lens.set_max_angle(1.6);
  lens.mutable_world_from_fisheye()->set_w(1);
  client.send(fisheye);
  ASSERT_TRUE(server.service.wait_environments(2));
  EXPECT_EQ(server.service.environments()[1].fisheye.max_angle, 1.6);

  client.send(frame_message(1));
  client.expect(Envelope::kComposite);  // and no word before it
}

TEST(Environment, ABadOneIsToldAndTheSessionGoesOn) {
  TestServer server;
  TestClient client = server.session();
  client.send(environment_message(kBadJpeg));
  const Error error = client.expect_error(Error::BAD_ENVIRONMENT);
  EXPECT_EQ(error.text(), "not a JPEG");
  EXPECT_EQ(error.frame_id(), 0u);
  EXPECT_FALSE(error.closes());
  Envelope lens = environment_message("jpeg");
  lens.mutable_environment()->mutable_fisheye()->set_width(100'000);
  client.send(lens);
  EXPECT_THAT(client.expect_error(Error::BAD_ENVIRONMENT).text(), HasSubstr("2048"));
  EXPECT_EQ(server.service.environments().size(), 1u);
  client.send(frame_message(1));
  client.expect(Envelope::kComposite);
}

TEST(Environment, OfManyTheNewestIsAppliedAndTheOthersAreTold) {
  net::ServerConfig config = test_config();
  config.session.environments_per_second = 1e6;
  TestServer server(config);
  TestClient client = server.session();
  server.service.hold();
  client.send(environment_message("first"));
  ASSERT_TRUE(server.service.wait_environments(1));
  client.send(environment_message("replaced"));
  client.send(environment_message("the newest"));
  EXPECT_THAT(client.expect_error(Error::BAD_ENVIRONMENT).text(), HasSubstr("replaced"));
  server.service.release();
  ASSERT_TRUE(server.service.wait_environments(2));
  EXPECT_EQ(server.service.environments()[1].image.size(), std::string("the newest").size());
}

TEST(Environment, ALargeOneIsTakenAndOneBeforeTheHelloIsNot) {
  TestServer server;
  TestClient client = server.session();
  client.send(environment_message(std::string(3'000'000, 'e')));
  EXPECT_TRUE(server.service.wait_environments(1));
  TestClient stranger = server.connect();
  stranger.send(environment_message("e"));
  stranger.expect_error(Error::UNEXPECTED_MESSAGE);
}

TEST(Environment, TheClientMayBeGoneWhenItIsApplied) {
  TestServer server;
  server.service.hold();
  {
    TestClient client = server.session();
    client.send(environment_message(kBadJpeg));
    ASSERT_TRUE(server.service.wait_environments(1));
  }
  EXPECT_TRUE(server.service.wait_views(0));
  server.service.release();
  TestClient next = server.session();
  next.send(frame_message(1));
  next.expect(Envelope::kComposite);
}

}  // namespace
}  // namespace amalgam::test
