// What an operator sees: the admin port, draining, and addresses that cannot be had.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/build_info.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using testing::HasSubstr;

TEST(Operation, AdminPagesOfAServerAtWork) {
  TestServer server;
  TestClient client = server.session();
  client.send(frame_message(1));
  client.expect(Envelope::kComposite);

  EXPECT_EQ(server.admin("/livez").status, 200);
  EXPECT_EQ(server.admin("/readyz").status, 200);
  EXPECT_EQ(server.admin("/nothing").status, 404);
  EXPECT_EQ(http_get(server.server().admin_address(), "/livez", "POST").status, 405);

  const HttpAnswer metrics = server.admin("/metrics");
  EXPECT_EQ(metrics.status, 200);
  EXPECT_THAT(metrics.head, HasSubstr("text/plain; version=0.0.4"));
  EXPECT_THAT(metrics.body, HasSubstr("amalgam_sessions 1"));
  EXPECT_THAT(metrics.body, HasSubstr("amalgam_frames_received_total 1"));

  const auto state = nlohmann::json::parse(server.admin("/state").body);
  EXPECT_EQ(state["ready"], true);
  EXPECT_EQ(state["version"], common::version());
  EXPECT_EQ(state["instruction_set"], common::instruction_set());
  ASSERT_EQ(state["sessions"].size(), 1u);
  EXPECT_EQ(state["sessions"][0]["width"], 640);
  EXPECT_EQ(state["sessions"][0]["frames_received"], 1);
}

TEST(Operation, NotReadyWhileLoadingOrFull) {
  net::ServerConfig config = test_config();
  net::Server loading(config);
  std::thread thread([&] { loading.run(); });
  const HttpAnswer answer = http_get(loading.admin_address(), "/readyz");
  EXPECT_EQ(answer.status, 503);
  EXPECT_EQ(answer.body, "loading\n");
  EXPECT_THROW(TestClient{loading.address()}, std::runtime_error);  // nobody listens yet
  loading.stop();
  thread.join();

  config.connections.total = 1;
  TestServer full(config);
  TestClient client = full.session();
  EXPECT_EQ(full.admin("/readyz").status, 503);
  EXPECT_EQ(full.admin("/livez").status, 200);
}

TEST(Operation, TheOldestConnectionOfTheAdminPortMakesRoom) {
  net::ServerConfig config = test_config();
  config.connections.admin = 1;
  TestServer server(config);
  TestClient holds_the_place(server.server().admin_address());
  EXPECT_EQ(server.admin("/livez").status, 200);
  EXPECT_TRUE(holds_the_place.closed_by_server());
}

TEST(Operation, DrainingFinishesWhatIsInFlight) {
  TestServer server;
  TestClient busy = server.session();
  TestClient idle = server.session();
  TestClient stranger = server.connect();
  server.service.hold();
  busy.send(frame_message(1));
  ASSERT_TRUE(server.service.wait_taken(1));

  server.server().drain();
  EXPECT_GT(idle.expect(Envelope::kDraining).draining().deadline_ms(), 0u);
  EXPECT_TRUE(idle.closed_by_server());
  stranger.expect(Envelope::kDraining);
  EXPECT_TRUE(stranger.closed_by_server());
  busy.expect(Envelope::kDraining);
  const HttpAnswer ready = server.admin("/readyz");
  EXPECT_EQ(ready.status, 503);
  EXPECT_EQ(ready.body, "draining\n");
  EXPECT_THROW(server.connect(), std::runtime_error);

  busy.send(frame_message(2));  // too late: skipped
  server.service.release();
  EXPECT_EQ(busy.expect(Envelope::kComposite).composite().frame_id(), 1u);
  EXPECT_TRUE(busy.closed_by_server());
  server.join();
}

TEST(Operation, FramesThatComeWhileDrainingAreSkippedAndCounted) {
  TestServer server;
  TestClient client = server.session();
  server.service.hold();
  client.send(frame_message(1));
  ASSERT_TRUE(server.service.wait_taken(1));
  server.server().drain();
  client.expect(Envelope::kDraining);
  client.send(frame_message(2));
  client.send(frame_message(3));
  Envelope ping;
  ping.mutable_ping()->set_nonce(1);
  client.send(ping);
  client.expect(Envelope::kPong);  // so they have been read
  EXPECT_THAT(server.admin("/metrics").body,
              HasSubstr("amalgam_frames_skipped_total{reason=\"draining\"} 2"));
  server.service.release();
  EXPECT_EQ(client.expect(Envelope::kComposite).composite().skipped(), 2u);
  EXPECT_TRUE(client.closed_by_server());
  server.join();
}

TEST(Operation, DrainingDoesNotWaitForEver) {
  net::ServerConfig config = test_config();
  config.drain_timeout = std::chrono::milliseconds(200);
  TestServer server(config);
  TestClient client = server.session();
  server.service.hold();
  client.send(frame_message(1));
  ASSERT_TRUE(server.service.wait_taken(1));
  server.server().drain();
  server.join();
  EXPECT_TRUE(server.service.wait_views(0));
}

TEST(Operation, AnAddressInUseIsSaid) {
  TestServer server;
  net::ServerConfig config = test_config();
  config.listen = server.server().address();
  try {
    net::Server second(config);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot listen on 127.0.0.1:"));
  }
  config.listen = {"localhost", 0};
  EXPECT_THROW(net::Server{config}, std::runtime_error);
}

}  // namespace
}  // namespace amalgam::test
