// Row 35: the light is everybody's, so not everybody may change it, and nobody all the time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "net/admission.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using testing::HasSubstr;

TEST(Environments, AFloodIsLimitedAndCounted) {
  TestServer server;
  const ControlClient::Felt alone = ControlClient::feel_alone(server.server().address());
  ControlClient control(server.server().address());
  TestClient client = server.session();
  constexpr int kSent = 200;
  int refused = 0;
  for (int i = 0; i < kSent; ++i) {
    client.send(environment_message(std::string(100'000, 'e')));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // see ControlClient
  }
  client.send(frame_message(1));
  for (;;) {
    const Envelope answer = client.receive().value();
    if (answer.has_composite()) break;
    EXPECT_EQ(answer.error().code(), Error::BAD_ENVIRONMENT);
    ++refused;
  }
  const auto felt = control.end();
  const auto applied = server.service.environments().size();
  print_figure("35", "environments that reached the renderer", static_cast<double>(applied),
               "of 200", "one a second");
  // A burst of two, and one for each second that a slow machine may have taken.
  EXPECT_LE(applied, 20u);
  EXPECT_GE(applied, 1u);
  expect_unharmed("35", alone, felt);
  EXPECT_THAT(server.admin("/metrics").body, HasSubstr("result=\"too_often\"} 1"));
  // Answers to who does not read are dropped, so not all that were refused are told.
  EXPECT_GT(refused, 0);
}

TestClient session_with(TestServer& server, const std::string& token) {
  TestClient client = server.connect();
  Envelope hello = hello_message();
  hello.mutable_hello()->set_token(token);
  client.send(hello);
  client.expect(Envelope::kWelcome);
  return client;
}

Envelope own_environment(const std::string& image) {
  Envelope message = environment_message(image);
  message.mutable_environment()->set_own(true);
  return message;
}

// An own environment harms nobody, so it needs no right; but it is limited by rate and by memory.
TEST(Environments, WhoMayViewMayLightTheOwnSession) {
  net::ServerConfig config = test_config();
  config.grants = {{"guest", {.view = true, .environment = false}}};
  config.environment_from = net::EnvironmentFrom::None;
  TestServer server(config);
  TestClient client = session_with(server, "guest");
  client.send(own_environment("one"));
  ASSERT_TRUE(server.service.wait_environments(1));
  EXPECT_TRUE(server.service.environments()[0].only_for.has_value());
  client.send(own_environment("two"));
  client.send(own_environment("three"));
  EXPECT_THAT(client.expect_error(Error::BAD_ENVIRONMENT).text(), HasSubstr("too often"));
  const auto has_own = [&] {
    return server.admin("/state").body.find("\"own_environment\": true") != std::string::npos;
  };
  // The renderer's thread says so a moment later.
  for (int i = 0; i < 200 && !has_own(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(has_own());
}

TEST(Environments, AnOwnOnesMemoryCountsUntilItsSessionEnds) {
  net::ServerConfig config = test_config();
  const std::uint64_t session = net::memory_of_session(common::default_camera(640, 480));
  constexpr std::uint64_t kImage = 1'000'000;
  config.admission = {.load = 0.0, .memory = 2 * session + 2 * kImage};
  config.session.environments_per_second = 1000.0;
  TestServer server(config);
  const auto memory = [&] {
    const std::string body = server.admin("/metrics").body,
                      name = "\namalgam_session_memory_bytes ";
    return std::stod(body.substr(body.find(name) + name.size()));
  };
  const auto becomes = [&](std::uint64_t bytes) {
    for (int i = 0; i < 200 && memory() != static_cast<double>(bytes); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return memory() == static_cast<double>(bytes);
  };
  TestClient stays = server.session();
  {
    TestClient client = server.session();
    client.send(own_environment(std::string(kImage, 'e')));
    EXPECT_TRUE(becomes(2 * session + kImage));
    // The new one and the old one fit together, once.
    client.send(own_environment(std::string(kImage, 'f')));
    ASSERT_TRUE(server.service.wait_environments(2));
    EXPECT_TRUE(becomes(2 * session + kImage)) << "the old one is given back";
    client.send(own_environment(std::string(kImage + 1, 'g')));
    EXPECT_THAT(client.expect_error(Error::BAD_ENVIRONMENT).text(), HasSubstr("no memory"));
    client.send(own_environment(std::string(kBadJpeg)));
    client.expect_error(Error::BAD_ENVIRONMENT);
    EXPECT_TRUE(becomes(2 * session + kImage)) << "a refused one takes nothing";
  }
  EXPECT_TRUE(becomes(session));
}

TEST(Environments, OnlyThoseWithTheRightChangeTheLight) {
  net::ServerConfig config = test_config();
  config.grants = {{"guest", {.view = true, .environment = false}},
                   {"boss", {.view = true, .environment = true}}};
  using From = net::EnvironmentFrom;
  struct Row {
    From from;
    const char* token;
    bool may;
  };
  for (const Row& row : {Row{From::Authorised, "guest", false}, Row{From::Authorised, "boss", true},
                         Row{From::Any, "guest", true}, Row{From::None, "boss", false}}) {
    config.environment_from = row.from;
    TestServer server(config);
    TestClient client = session_with(server, row.token);
    client.send(environment_message("light"));
    if (row.may) {
      EXPECT_TRUE(server.service.wait_environments(1)) << row.token;
    } else {
      client.expect_error(Error::BAD_ENVIRONMENT);
      EXPECT_TRUE(server.service.environments().empty()) << row.token;
    }
  }
}

}  // namespace
}  // namespace amalgam::test
