// Row 35: the light is everybody's, so not everybody may change it, and nobody all the time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using testing::HasSubstr;

TEST(Environments, AFloodIsLimitedAndCounted) {
  TestServer server;
  ControlClient control(server.server().address());
  TestClient client = server.session();
  constexpr int kSent = 200;
  int refused = 0;
  for (int i = 0; i < kSent; ++i) client.send(environment_message(std::string(100'000, 'e')));
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
  print_figure("35", "control's p99", felt.p99_ms, "ms", "+10 %");
  // A burst of two, and one for each second that a slow machine may have taken.
  EXPECT_LE(applied, 20u);
  EXPECT_GE(applied, 1u);
  EXPECT_FALSE(felt.lost);
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
