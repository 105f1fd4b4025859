// The load program's own counts, against a server whose renderer is a stub.
#include <gtest/gtest.h>

#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

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
