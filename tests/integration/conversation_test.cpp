// What a well-behaved client sees of a real server over a real socket.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>
#include <vector>

#include "protocol/limits.h"
#include "support/net/each_transport.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using testing::ElementsAre;

class Conversation : public EachTransport {};

TEST_P(Conversation, WelcomeSaysLimitsAndMarkers) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.connect();
  client.send(hello_message());
  const protocol::Welcome welcome = client.expect(Envelope::kWelcome).welcome();
  EXPECT_GT(welcome.session(), 0u);
  EXPECT_EQ(welcome.limits().max_message_bytes(), protocol::kMaxCameraFrameBytes);
  EXPECT_EQ(welcome.limits().max_poses(), 64u);
  EXPECT_EQ(welcome.markers().dictionary(), "DICT_6X6_250");
  EXPECT_EQ(welcome.markers().world_marker(), 40);
  EXPECT_THAT(welcome.markers().ids(), ElementsAre(40, 23));
}

TEST_P(Conversation, FramesComeBackAsComposites) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  for (std::uint64_t id = 10; id < 20; ++id) {
    Envelope frame = frame_message(id, "jpeg " + std::to_string(id));
    add_pose(frame, 40, 0.25);
    client.send(frame);
    const protocol::Composite composite = client.expect(Envelope::kComposite).composite();
    EXPECT_EQ(composite.frame_id(), id);
    EXPECT_EQ(composite.capture_time_us(), id * 1000);
    EXPECT_EQ(composite.jpeg(), "jpeg " + std::to_string(id));
    EXPECT_FALSE(composite.unchanged());
    ASSERT_EQ(composite.poses_size(), 1);
    EXPECT_EQ(composite.poses(0).translation().z(), 0.25);
    ASSERT_EQ(composite.stages_size(), 1);
    EXPECT_EQ(composite.stages(0).name(), "trace");
    ASSERT_EQ(composite.passes_size(), 2);
    EXPECT_EQ(composite.passes(1).reason(), "no lens distortion");
    EXPECT_EQ(composite.rays().primary(), 7u);
    EXPECT_EQ(composite.pixels().total(), 100u);
    EXPECT_EQ(composite.skipped(), 0u);
    EXPECT_GE(composite.server_ms(), 0.0);
  }
}

TEST_P(Conversation, ClientsAreServedSideBySide) {
  TestServer server(test_config(), GetParam());
  std::vector<TestClient> clients;
  for (int i = 0; i < 8; ++i) clients.push_back(server.session());
  for (std::uint64_t round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < clients.size(); ++i) {
      clients[i].send(frame_message(round, "client " + std::to_string(i)));
    }
    for (std::size_t i = 0; i < clients.size(); ++i) {
      EXPECT_EQ(clients[i].expect(Envelope::kComposite).composite().jpeg(),
                "client " + std::to_string(i));
    }
  }
}

TEST_P(Conversation, TheNewestFrameWinsAndTheOthersAreCounted) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  server.service.hold();
  client.send(frame_message(1));
  ASSERT_TRUE(server.service.wait_taken(1));
  for (std::uint64_t id = 2; id <= 10; ++id) client.send(frame_message(id));
  ASSERT_TRUE(server.service.wait_submitted(10));
  server.service.release();
  EXPECT_EQ(client.expect(Envelope::kComposite).composite().frame_id(), 1u);
  const protocol::Composite last = client.expect(Envelope::kComposite).composite();
  EXPECT_EQ(last.frame_id(), 10u);
  EXPECT_EQ(last.skipped(), 8u);
}

TEST_P(Conversation, PingIsAnsweredWithItsNonce) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  Envelope ping;
  ping.mutable_ping()->set_nonce(77);
  client.send(ping);
  EXPECT_EQ(client.expect(Envelope::kPong).pong().nonce(), 77u);
}

TEST_P(Conversation, AStreamInAnyPiecesMeansTheSame) {
  TestServer server(test_config(), GetParam());
  std::string stream = protocol::encode(hello_message());
  for (std::uint64_t id = 1; id <= 3; ++id) {
    Envelope ping;
    ping.mutable_ping()->set_nonce(id);
    stream += protocol::encode(ping);
  }
  TestClient bytewise = server.connect();
  for (const char byte : stream) bytewise.send_bytes(std::string_view(&byte, 1));
  TestClient coalesced = server.connect();
  coalesced.send_bytes(stream);
  for (TestClient* client : {&bytewise, &coalesced}) {
    client->expect(Envelope::kWelcome);
    for (std::uint64_t id = 1; id <= 3; ++id) {
      EXPECT_EQ(client->expect(Envelope::kPong).pong().nonce(), id);
    }
  }
}

TEST_P(Conversation, GoodbyeEndsTheSession) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  ASSERT_TRUE(server.service.wait_views(1));
  Envelope goodbye;
  goodbye.mutable_goodbye();
  client.send(goodbye);
  EXPECT_TRUE(client.closed_by_server());
  EXPECT_TRUE(server.service.wait_views(0));
}

TEST_P(Conversation, AFrameInFlightWhenTheClientVanishesIsDropped) {
  TestServer server(test_config(), GetParam());
  server.service.hold();
  {
    TestClient client = server.session();
    client.send(frame_message(1));
    ASSERT_TRUE(server.service.wait_taken(1));
  }
  EXPECT_TRUE(server.service.wait_views(0));
  server.service.release();
  TestClient next = server.session();
  next.send(frame_message(2));
  EXPECT_EQ(next.expect(Envelope::kComposite).composite().frame_id(), 2u);
}

TEST_P(Conversation, ABadPoseIsToldAndTheLastGoodOneHeld) {
  net::ServerConfig config = test_config();
  config.session.pose_hold = std::chrono::minutes(1);  // the machine may be slow
  TestServer server(config, GetParam());
  TestClient client = server.session();
  Envelope good = frame_message(1);
  add_pose(good, 40, 0.75);
  client.send(good);
  client.expect(Envelope::kComposite);

  Envelope bad = frame_message(2);
  add_pose(bad, 40, std::numeric_limits<double>::infinity());
  add_pose(bad, 23, std::numeric_limits<double>::quiet_NaN());
  client.send(bad);
  const Error error = client.expect_error(Error::POSE_REJECTED);
  EXPECT_EQ(error.frame_id(), 2u);
  EXPECT_FALSE(error.closes());
  const protocol::Composite composite = client.expect(Envelope::kComposite).composite();
  ASSERT_EQ(composite.poses_size(), 1);
  EXPECT_EQ(composite.poses(0).marker(), 40);
  EXPECT_EQ(composite.poses(0).translation().z(), 0.75);
}

TEST(Holding, ALostMarkerIsHeldAndThenTheImageComesBackUnchanged) {
  net::ServerConfig config = test_config();
  config.session.pose_hold = std::chrono::milliseconds(2000);  // the machine may be slow
  TestServer server(config);
  TestClient client = server.session();
  const auto seen = std::chrono::steady_clock::now();
  Envelope frame = frame_message(1);
  add_pose(frame, 40, 0.75);
  client.send(frame);
  EXPECT_FALSE(client.expect(Envelope::kComposite).composite().unchanged());

  client.send(frame_message(2));  // no pose, no error
  const protocol::Composite held = client.expect(Envelope::kComposite).composite();
  EXPECT_FALSE(held.unchanged());
  ASSERT_EQ(held.poses_size(), 1);
  EXPECT_EQ(held.poses(0).translation().z(), 0.75);

  std::uint64_t id = 2;
  protocol::Composite composite = held;
  while (composite.poses_size() > 0) {
    ASSERT_LT(++id, 300u) << "held for ever";
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    client.send(frame_message(id));
    composite = client.expect(Envelope::kComposite).composite();
  }
  EXPECT_TRUE(composite.unchanged());
  EXPECT_GE(std::chrono::steady_clock::now() - seen, config.session.pose_hold);
}

TEST_P(Conversation, WhatOneFrameDidWrongDoesNotEndTheSession) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  client.send(frame_message(1, kBadJpeg));
  EXPECT_EQ(client.expect_error(Error::BAD_IMAGE).frame_id(), 1u);

  Envelope crowded = frame_message(2);
  for (int marker = 0; marker < 65; ++marker) add_pose(crowded, marker);
  client.send(crowded);
  EXPECT_EQ(client.expect_error(Error::TOO_MANY_POSES).frame_id(), 2u);

  client.send(environment_message(""));
  EXPECT_FALSE(client.expect_error(Error::BAD_ENVIRONMENT).closes());

  client.send(frame_message(3));
  const protocol::Composite composite = client.expect(Envelope::kComposite).composite();
  EXPECT_EQ(composite.frame_id(), 3u);
  EXPECT_EQ(composite.skipped(), 2u);
}

TEST_P(Conversation, TheTokenAdmits) {
  net::ServerConfig config = test_config();
  config.grants = {{"opensesame", {.view = true, .environment = true}}};
  TestServer server(config, GetParam());
  TestClient client = server.connect();
  Envelope hello = hello_message();
  hello.mutable_hello()->set_token("opensesame");
  client.send(hello);
  client.expect(Envelope::kWelcome);
}

INSTANTIATE_TEST_SUITE_P(Over, Conversation, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
