// Files that the web port makes when they are asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>

#include "net/tls.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using testing::HasSubstr;

// Makes "sheet N" the N-th time, and may be held while it does.
struct Maker {
  std::atomic<int> begun = 0;
  std::promise<void> released;
  std::shared_future<void> release{released.get_future()};
};

net::ServerConfig config_with(Maker& maker) {
  net::ServerConfig config = test_config();
  config.web_options.made["/sheet.pdf?paper=a4"] =
      [&maker](const frame::FrameService::MarkerSet& markers) {
        const int count = ++maker.begun;
        maker.release.wait();
        return "sheet " + std::to_string(count) + " of " + markers.dictionary;
      };
  config.web_options.made["/none.pdf?paper=a4"] =
      [](const frame::FrameService::MarkerSet&) -> std::string {
    throw std::runtime_error("a marker does not fit on a page");
  };
  return config;
}

constexpr const char* kSheet = "/sheet.pdf?paper=a4";

void wait_until_begun(const Maker& maker) {
  while (maker.begun == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(MadeFiles, AreMadeOnceForAllWhoAsk) {
  Maker maker;
  TestServer server(config_with(maker), Over::WebSocket);
  const auto ask = [&] { return http_get(server.address(), kSheet).body; };
  auto first = std::async(std::launch::async, ask);
  wait_until_begun(maker);
  auto second = std::async(std::launch::async, ask);
  maker.released.set_value();
  EXPECT_EQ(first.get(), "sheet 1 of DICT_6X6_250");
  EXPECT_EQ(second.get(), "sheet 1 of DICT_6X6_250");
  const HttpAnswer third = http_get(server.address(), kSheet);
  EXPECT_EQ(third.body, "sheet 1 of DICT_6X6_250");
  EXPECT_THAT(third.head, HasSubstr("Content-Type: application/pdf"));
  EXPECT_EQ(http_get(server.address(), kSheet, "HEAD").status, 200);
  EXPECT_EQ(maker.begun, 1);
}

TEST(MadeFiles, NobodyElseWaitsForThem) {
  Maker maker;
  TestServer server(config_with(maker), Over::WebSocket);
  TestClient waiting(server.address());
  waiting.send_raw(std::string("GET ") + kSheet + " HTTP/1.1\r\nHost: x\r\n\r\n");
  wait_until_begun(maker);
  server.session();  // a whole hello and welcome
  EXPECT_EQ(server.admin("/livez").status, 200);
  EXPECT_EQ(http_get(server.address(), "/none.pdf").status, 404);
  maker.released.set_value();
}

// Who has left, or has been closed for waiting too long, must not be written to.
TEST(MadeFiles, WhoLeavesMeanwhileIsForgotten) {
  Maker maker;
  net::ServerConfig config = config_with(maker);
  config.session.hello_timeout = std::chrono::milliseconds(100);
  TestServer server(config, Over::WebSocket);
  {
    TestClient leaving(server.address());
    leaving.send_raw(std::string("GET ") + kSheet + " HTTP/1.1\r\nHost: x\r\n\r\n");
    wait_until_begun(maker);
    EXPECT_EQ(leaving.receive_raw(1000), 0u);  // its time is over
  }
  maker.released.set_value();
  EXPECT_EQ(http_get(server.address(), kSheet).body, "sheet 1 of DICT_6X6_250");
  EXPECT_THAT(server.admin("/metrics").body, HasSubstr("amalgam_connections 0"));
}

TEST(MadeFiles, AReloadMakesThemAnew) {
  Maker maker;
  maker.released.set_value();
  const net::ServerConfig config = config_with(maker);
  TestServer server(config, Over::WebSocket);
  EXPECT_EQ(http_get(server.address(), kSheet).body, "sheet 1 of DICT_6X6_250");
  std::promise<void> done;
  server.server().post([&] {
    server.server().configure(config, net::make_tls_context(config.tls));
    done.set_value();
  });
  done.get_future().wait();
  EXPECT_EQ(http_get(server.address(), kSheet).body, "sheet 2 of DICT_6X6_250");
  EXPECT_EQ(http_get(server.address(), kSheet).body, "sheet 2 of DICT_6X6_250");
}

TEST(MadeFiles, WhyThereIsNoneIsSaid) {
  Maker maker;
  TestServer server(config_with(maker), Over::WebSocket);
  const HttpAnswer answer = http_get(server.address(), "/none.pdf?paper=a4");
  EXPECT_EQ(answer.status, 404);
  EXPECT_EQ(answer.body, "a marker does not fit on a page\n");
}

}  // namespace
}  // namespace amalgam::test
