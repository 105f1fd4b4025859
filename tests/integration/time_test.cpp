// Time-outs of a session, shortened so that the tests are quick, but never so short that a slow
// machine would trip over another one first.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "protocol/limits.h"
#include "support/net/each_transport.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

class Time : public EachTransport {};

TEST_P(Time, AHelloThatDoesNotComeOrComesBitByBit) {
  net::ServerConfig config = test_config();
  config.session.hello_timeout = milliseconds(300);
  TestServer server(config, GetParam());
  const auto begin = Clock::now();
  TestClient silent = server.connect();
  TestClient dripping = server.connect();
  for (const char byte : protocol::encode(hello_message()).substr(0, 6)) {
    dripping.send_bytes(std::string_view(&byte, 1));
    std::this_thread::sleep_for(milliseconds(20));
  }
  silent.expect_error(Error::AUTH_TIMEOUT);
  dripping.expect_error(Error::AUTH_TIMEOUT);
  EXPECT_GE(Clock::now() - begin, milliseconds(300));
  EXPECT_TRUE(silent.closed_by_server());
}

TEST_P(Time, AMessageThatDoesNotEnd) {
  net::ServerConfig config = test_config();
  config.session.message_timeout = milliseconds(300);
  TestServer server(config, GetParam());
  TestClient client = server.session();
  const std::string frame = protocol::encode(frame_message(1, std::string(1000, 'j')));
  client.send_bytes(frame.substr(0, 500));
  client.expect_error(Error::SLOW_SENDER);
  EXPECT_TRUE(client.closed_by_server());
}

TEST_P(Time, AMessageThatComesTooSlowly) {
  net::ServerConfig config = test_config();
  config.session.rate_grace = milliseconds(200);
  config.session.ping_interval = milliseconds(100);  // how often the rate is looked at
  TestServer server(config, GetParam());
  TestClient client = server.session();
  const auto begin = Clock::now();
  const std::string frame = protocol::encode(frame_message(1, std::string(1000, 'j')));
  client.send_bytes(frame.substr(0, 500));
  client.expect_error(Error::SLOW_SENDER);
  EXPECT_LT(Clock::now() - begin, config.session.message_timeout);
}

TEST_P(Time, PingsKeepAQuietClient) {
  net::ServerConfig config = test_config();
  config.session.ping_interval = milliseconds(50);
  config.session.idle_timeout = milliseconds(2000);
  TestServer server(config, GetParam());
  TestClient client = server.session();
  // Reading answers the pings; what ends the reading comes after more than the time-out. The client
  // is of use to one thread only.
  std::thread later([&] {
    std::this_thread::sleep_for(milliseconds(2500));
    server.server().drain();
  });
  EXPECT_EQ(client.receive().value_or(Envelope()).body_case(), Envelope::kDraining);
  later.join();
  EXPECT_GE(client.pings(), 5u);
}

TEST_P(Time, SilenceEndsTheSession) {
  net::ServerConfig config = test_config();
  config.session.ping_interval = milliseconds(50);
  config.session.idle_timeout = milliseconds(300);
  TestServer server(config, GetParam());
  TestClient client = server.session();
  client.answer_pings(false);
  client.expect_error(Error::IDLE_TIMEOUT);
  EXPECT_TRUE(client.closed_by_server());
  EXPECT_TRUE(server.service.wait_views(0));
}

TEST_P(Time, AReaderThatStopsIsEvicted) {
  net::ServerConfig config = test_config();
  config.session.ping_interval = milliseconds(50);
  config.session.write_timeout = milliseconds(500);
  TestServer server(config, GetParam());
  TestClient client = server.connect(4096);
  client.send(hello_message());
  client.expect(Envelope::kWelcome);
  // More than all buffers between here and there can hold, and nothing is read.
  const std::string jpeg(3'000'000, 'j');
  for (std::uint64_t id = 1; id <= 5 && client.send(frame_message(id, jpeg)); ++id) {
  }
  EXPECT_TRUE(server.service.wait_views(0));
  EXPECT_NE(server.admin("/metrics").body.find("amalgam_errors_total{code=\"SLOW_READER\"} 1"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Over, Time, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
