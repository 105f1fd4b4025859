// Row 8: wrong tokens slow an address down, and nobody else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "net/back_off.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using namespace std::chrono_literals;

TEST(Tokens, AThousandWrongOnesAreAFewTries) {
  net::ServerConfig config = test_config();
  config.grants = {{"opensesame", {.view = true, .environment = true}}};
  TestServer server(config);
  const ControlClient::Felt alone =
      ControlClient::feel_alone(server.server().address(), "opensesame");
  ControlClient control(server.server().address(), "opensesame");
  Envelope hello = hello_message();
  hello.mutable_hello()->set_token("guess");
  int judged = 0, sent_away = 0;
  for (int i = 0; i < 1000; ++i) {
    TestClient client = server.connect();
    // Whoever is sent away may find the connection closed before its hello was read.
    client.send(hello);
    const Envelope answer = client.receive().value_or(Envelope());
    if (answer.has_error()) ++judged;
    if (answer.has_busy() || answer.body_case() == Envelope::BODY_NOT_SET) ++sent_away;
  }
  const auto felt = control.end();
  print_figure("8", "of 1000 wrong tokens judged", judged, "", "backed off by address");
  EXPECT_GE(judged, 1);
  EXPECT_LE(judged, net::BackOff::kFree + 5);
  EXPECT_EQ(judged + sent_away, 1000);
  expect_unharmed("8", alone, felt);
  EXPECT_THAT(server.admin("/metrics").body, testing::HasSubstr("reason=\"back_off\"}"));
}

TEST(Tokens, TheWaitDoublesAndEnds) {
  net::BackOff back_off;
  const net::BackOff::Time start = net::BackOff::Time() + 1h;
  for (int i = 0; i < net::BackOff::kFree; ++i) back_off.failed("a", start);
  EXPECT_EQ(back_off.left("a", start), 0ms);
  for (const auto wait : {1000ms, 2000ms, 4000ms, 8000ms, 16000ms, 32000ms, 60000ms, 60000ms}) {
    back_off.failed("a", start);
    EXPECT_EQ(back_off.left("a", start), wait);
    EXPECT_EQ(back_off.left("a", start + wait), 0ms);
  }
  EXPECT_EQ(back_off.left("b", start), 0ms);
  back_off.succeeded("a");
  EXPECT_EQ(back_off.left("a", start), 0ms);
  // Forgotten after ten quiet minutes.
  for (int i = 0; i < 9; ++i) back_off.failed("c", start);
  back_off.failed("c", start + net::BackOff::kMemory + 1s);
  EXPECT_EQ(back_off.left("c", start + net::BackOff::kMemory + 1s), 0ms);
}

}  // namespace
}  // namespace amalgam::test
