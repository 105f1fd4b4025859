// The page's files from a real server, and what else comes to its web port.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <string>
#include <thread>

#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

const std::string kLarge(3'000'000, 'w');
const std::array<web::WebFile, 2> kFiles{{{"index.html", "text/html", "<p>", "\"1\""},
                                          {"large.wasm", "application/wasm", kLarge, "\"2\""}}};

net::ServerConfig with_page() {
  net::ServerConfig config = test_config();
  config.web_options.files = kFiles;
  config.session.hello_timeout = milliseconds(400);
  config.session.linger = milliseconds(200);
  return config;
}

TEST(WebPage, ComesWholeAndLeavesItsPlace) {
  TestServer server(with_page(), Over::WebSocket);
  EXPECT_EQ(http_get(server.address(), "/").body, "<p>");
  const HttpAnswer large = http_get(server.address(), "/large.wasm");
  EXPECT_EQ(large.status, 200);
  EXPECT_TRUE(large.body == kLarge);
  EXPECT_EQ(http_get(server.address(), "/", "DELETE").status, 405);
  EXPECT_EQ(http_get(server.address(), "/../etc/passwd").status, 404);
  EXPECT_EQ(http_get(server.address(), "/%2e%2e/etc/passwd").status, 404);
  EXPECT_EQ(http_get(server.address(), "/session").status, 426);
  const std::string metrics = server.admin("/metrics").body;
  EXPECT_THAT(metrics, HasSubstr("amalgam_connections_accepted_total{transport=\"websocket\"} 6"));
  EXPECT_THAT(metrics, HasSubstr("amalgam_connections 0"));
  EXPECT_EQ(server.service.opened(), 0u);
}

// Longer than a hello may take, as long as it goes on.
TEST(WebPage, ASlowReaderGetsItToo) {
  TestServer server(with_page(), Over::WebSocket);
  TestClient slow(server.address(), 64 * 1024);
  slow.send_raw("GET /large.wasm HTTP/1.1\r\nHost: x\r\n\r\n");
  const auto begin = Clock::now();
  std::size_t bytes = 0;
  while (const std::size_t size = slow.receive_raw(64 * 1024)) {
    bytes += size;
    std::this_thread::sleep_for(milliseconds(25));
  }
  EXPECT_GT(bytes, kLarge.size());
  EXPECT_GT(Clock::now() - begin, milliseconds(700));
}

TEST(WebPage, WhoStopsReadingLosesHisPlace) {
  TestServer server(with_page(), Over::WebSocket);
  TestClient stopped(server.address(), 4096);
  stopped.send_raw("GET /large.wasm HTTP/1.1\r\nHost: x\r\n\r\n");
  std::string metrics;
  const auto begin = Clock::now();
  do {
    std::this_thread::sleep_for(milliseconds(50));
    metrics = server.admin("/metrics").body;
  } while (metrics.find("amalgam_connections 0") == std::string::npos &&
           Clock::now() - begin < std::chrono::seconds(10));
  EXPECT_THAT(metrics, HasSubstr("amalgam_connections 0"));
}

TEST(WebPage, GarbageAndHugeRequestsAreRefused) {
  TestServer server(with_page(), Over::WebSocket);
  EXPECT_EQ(http_exchange(server.address(), "\x16\x03\x01 hello\r\n\r\n").status, 400);
  EXPECT_EQ(http_exchange(server.address(), protocol::encode(hello_message())).status, 400);
  EXPECT_EQ(http_exchange(server.address(), std::string("GET /a\0b HTTP/1.1\r\n\r\n", 22)).status,
            400);
  const std::string long_target = "GET /" + std::string(9000, 'a') + " HTTP/1.1\r\n\r\n";
  EXPECT_EQ(http_exchange(server.address(), long_target).status, 431);
  // Nothing that ends: it has the hello's time.
  const auto begin = Clock::now();
  TestClient dripping(server.address());
  dripping.send_raw("GET / HT");
  while (dripping.receive_raw(1000) > 0) {
  }
  EXPECT_GE(Clock::now() - begin, milliseconds(400));
}

TEST(WebPage, AServerWithoutItSaysSo) {
  TestServer server(test_config(), Over::WebSocket);
  const HttpAnswer answer = http_get(server.address(), "/");
  EXPECT_EQ(answer.status, 404);
  EXPECT_EQ(answer.body, "This server was built without the page.\n");
}

}  // namespace
}  // namespace amalgam::test
