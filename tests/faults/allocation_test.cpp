// Row 21: the k-th allocation of the network thread fails. What it was for ends; the server lives.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "common/log.h"
#include "faults/failing_allocation.h"
#include "faults/figure.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

// Each round does a little of everything; it may be cut short anywhere.
void use_the_server(TestServer& server, int round) {
  try {
    TestClient client = server.connect();
    client.send(hello_message());
    for (std::uint64_t id = 1; id <= 2; ++id) {
      protocol::Envelope frame = frame_message(id, id == 1 ? "jpeg" : kBadJpeg);
      add_pose(frame, 40);
      if (!client.send(frame)) return;
    }
    client.send(environment_message("light"));
    client.finish_sending();
    while (client.receive()) {
    }
    if (round % 4 == 0) server.admin("/metrics");
    if (round % 4 == 1) server.admin("/state");
    if (round % 4 == 2) server.admin("/readyz");
  } catch (const std::exception&) {
  }
}

TEST(Allocation, TheKthFailureEndsNoServer) {
  common::set_log_level("off");
  net::ServerConfig config = test_config();
  config.connections.per_address = 100;
  config.session.idle_timeout = std::chrono::milliseconds(1000);
  TestServer server(config);
  server.server().post([] { arm_this_thread(true); });
  // Each failing allocation in a round of its own, up to the last that a round makes.
  int rounds = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (std::int64_t k = 0; k < 1000; ++k, ++rounds) {
    fail_allocation(k);
    use_the_server(server, rounds);
    fail_no_allocation();
    if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(12)) break;
  }
  print_figure("21", "allocations failed", static_cast<double>(failed_allocations()), "",
               "all k <= 1000");
  EXPECT_GT(failed_allocations(), 100u);
  // Gone are those that failed, and the server is as it was.
  EXPECT_TRUE(server.service.wait_views(0));
  EXPECT_EQ(server.admin("/livez").status, 200);
  TestClient client = server.session();
  client.send(frame_message(1));
  client.expect(protocol::Envelope::kComposite);
}

}  // namespace
}  // namespace amalgam::test
