// Rows 20 and 24: clients come and go, and so may the server.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "client/link/connection.h"
#include "client/link/messages.h"
#include "client/tracking/calibration.h"
#include "faults/figure.h"
#include "net/process_figures.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

TEST(Cycles, ClientsThatComeAndGoLeaveNothingBehind) {
  TestServer server;
  const auto cycle = [&] {
    std::vector<TestClient> clients;
    for (std::uint64_t i = 0; i < 4; ++i) {
      clients.push_back(server.session());
      clients.back().send(frame_message(i + 1));
      clients.back().expect(protocol::Envelope::kComposite);
    }
    clients.clear();
    EXPECT_TRUE(server.service.wait_views(0));
  };
  const auto all_closed = [&] {
    for (int i = 0; i < 500; ++i) {
      if (server.admin("/state").body.find("\"connections\": 0") != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  for (int i = 0; i < 20; ++i) cycle();
  ASSERT_TRUE(all_closed());
  const net::ProcessFigures before = net::read_process_figures();
  for (int i = 0; i < 200; ++i) cycle();
  ASSERT_TRUE(all_closed());
  const net::ProcessFigures after = net::read_process_figures();
  const double mib =
      (static_cast<double>(after.resident_bytes) - static_cast<double>(before.resident_bytes)) /
      (1024.0 * 1024.0);
  print_figure("20", "200 cycles of 4 clients keep", mib / 200.0, "MiB a cycle", "< 0.1");
  EXPECT_LT(mib / 200.0, 0.1);
  // The admin port's last connection may still be closing.
  EXPECT_LE(after.open_descriptors, before.open_descriptors + 1);
}

TEST(Cycles, ClientsFindARestartedServer) {
  net::ServerConfig config = test_config();
  auto server = std::make_unique<TestServer>(config);
  config.listen = server->server().address();
  client::Connection connection({.server = config.listen},
                                client::hello_message(common::default_camera(64, 48), "", 0));
  const auto wait_for_welcome = [&] {
    for (;;) {
      const auto event = connection.wait(std::chrono::seconds(10));
      if (!event) return false;
      if (std::holds_alternative<client::Welcomed>(*event)) return true;
    }
  };
  ASSERT_TRUE(wait_for_welcome());
  server.reset();
  server = std::make_unique<TestServer>(config);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(wait_for_welcome());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  print_figure("24", "served again after", seconds, "s", "<= 2 s");
  EXPECT_LT(seconds, 8.0);
}

}  // namespace
}  // namespace amalgam::test
