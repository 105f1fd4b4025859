// The load program's own counts, against a server whose renderer is a stub.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "client/tools/load/arrivals.h"
#include "client/tools/load/load_client.h"
#include "protocol/client_tls.h"
#include "support/net/test_server.h"

namespace amalgam::load {
namespace {

LoadSummary run(test::TestServer& server, LoadOptions options) {
  options.server = server.server().address();
  options.rate = 200.0;
  const LoadImage image = grey_image(64, 48);
  LoadSummary summary;
  boost::asio::io_context io(1);
  for (int i = 0; i < options.clients; ++i) {
    std::make_shared<LoadClient>(io, options, image, summary, i)->start();
  }
  io.run();
  return summary;
}

TEST(Load, EveryFrameIsCompositedSkippedOrUnsent) {
  test::TestServer server;
  LoadOptions options;
  options.clients = 4;
  options.frames = 20;
  const LoadSummary summary = run(server, options);
  EXPECT_EQ(summary.welcomed, 4);
  EXPECT_EQ(summary.lost, 0);
  EXPECT_EQ(summary.sent, 80u);
  EXPECT_EQ(summary.composited + summary.skipped, summary.sent);
  EXPECT_EQ(summary.latencies_ms.size(), summary.composited);
  EXPECT_TRUE(summary.errors.empty());
  EXPECT_GT(summary.bytes_received, 0u);
}

TEST(Load, FaultsAreAnswered) {
  test::TestServer server;
  LoadOptions options;
  options.frames = 5;
  options.fault = Fault::BadPose;
  EXPECT_EQ(run(server, options).errors.at("POSE_REJECTED"), 5u);
  options.fault = Fault::Cut;
  EXPECT_EQ(run(server, options).lost, 0);
  EXPECT_TRUE(server.service.wait_views(0));
}

// A server that hangs for a third of a second delays every frame that was due in that time. Its
// composites alone, of which it sends few then, would hide that.
TEST(Load, LatenciesAreOfAllFramesThatWereDue) {
  test::TestServer server;
  LoadOptions options;
  options.frames = 160;  // 0.8 s
  std::thread hang([&] {
    server.service.wait_taken(20);
    server.service.hold();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    server.service.release();
  });
  const LoadSummary summary = run(server, options);
  hang.join();
  // A frame that could not be sent was due all the same.
  EXPECT_EQ(summary.due.size() + summary.unanswered, 160u + summary.unsent);
  EXPECT_EQ(summary.unanswered, 0u);
  const auto late = std::count_if(summary.due.begin(), summary.due.end(),
                                  [](const auto& frame) { return frame.latency > 100.0; });
  const auto late_composites =
      std::count_if(summary.latencies_ms.begin(), summary.latencies_ms.end(),
                    [](double latency) { return latency > 100.0; });
  // Due in the first 200 of the 300 ms, 5 ms apart.
  EXPECT_GE(late, 35);
  EXPECT_LE(late_composites, 10);
}

TEST(Load, EveryFaultIsCommitted) {
  net::ServerConfig config = test::test_config();
  config.grants = {{"secret", {.view = true, .environment = true}}};
  config.session.hello_timeout = std::chrono::milliseconds(200);
  test::TestServer server(config);
  LoadOptions options;
  options.frames = 5;
  options.token = "secret";
  const auto with = [&](Fault fault) {
    options.fault = fault;
    return run(server, options);
  };
  EXPECT_EQ(with(Fault::WrongToken).errors.at("AUTH_FAILED"), 1u);
  EXPECT_EQ(with(Fault::HalfOpen).errors.at("AUTH_TIMEOUT"), 1u);
  EXPECT_EQ(with(Fault::Garbage).errors.at("PROTOCOL_ERROR"), 1u);
  const LoadSummary hello = with(Fault::HelloOnly);
  EXPECT_EQ(hello.welcomed, 1);
  EXPECT_EQ(hello.sent, 0u);
  EXPECT_GT(with(Fault::Environments).errors.at("BAD_ENVIRONMENT"), 0u) << "too often";
  const auto environments = server.service.environments();
  ASSERT_EQ(environments.size(), 2u);
  EXPECT_NE(environments[0].only_for.has_value(), environments[1].only_for.has_value());
  const LoadSummary deaf = with(Fault::SlowReader);
  EXPECT_EQ(deaf.sent, 5u);
  EXPECT_EQ(deaf.composited, 0u);
  EXPECT_TRUE(server.service.wait_views(0));
}

// As many as the rate says, at any times: exponential gaps are as long as their deviation.
TEST(Load, ArrivalsAreAtRandomTimesAndWaitForNobody) {
  boost::asio::io_context io(1);
  LoadOptions options;
  options.arrivals = 1000.0;
  options.duration = std::chrono::milliseconds(400);
  const auto begin = Arrivals::Clock::now();
  std::vector<int> numbers;
  Arrivals arrivals(io, options, begin, [&](int number) { numbers.push_back(number); });
  arrivals.wait();
  io.run();
  EXPECT_EQ(arrivals.count(), static_cast<int>(numbers.size()));
  EXPECT_EQ(numbers.back(), arrivals.count() - 1);
  EXPECT_NEAR(arrivals.count(), 400, 60);  // three deviations
}

TEST(Load, EncryptsForServersThatAreTrusted) {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("amalgam-load-" + std::to_string(::getpid()));
  ASSERT_EQ(std::system(("deploy/make_test_certificate.sh " + folder.string()).c_str()), 0);
  net::ServerConfig config = test::test_config();
  config.tls = {folder / "server.crt", folder / "server.key"};
  {
    test::TestServer server(config);
    LoadOptions options;
    options.frames = 5;
    options.tls = protocol::client_tls(folder / "server.crt");
    const LoadSummary summary = run(server, options);
    EXPECT_EQ(summary.welcomed, 1);
    EXPECT_EQ(summary.composited + summary.skipped, 5u);
    options.tls = protocol::client_tls("");
    EXPECT_EQ(run(server, options).lost, 1);
  }
  fs::remove_all(folder);
}

TEST(Load, ConnectionsAboveTheCapAreCountedAsLost) {
  net::ServerConfig config = test::test_config();
  config.connections.per_address = 2;
  test::TestServer server(config);
  LoadOptions options;
  options.clients = 3;
  options.frames = 5;
  const LoadSummary summary = run(server, options);
  EXPECT_EQ(summary.welcomed, 2);
  EXPECT_EQ(summary.lost, 1);
  // Two from one address and one from another.
  options.sources = 2;
  EXPECT_EQ(run(server, options).welcomed, 3);
}

}  // namespace
}  // namespace amalgam::load
