// Row 37: what is not used any more is given back.
#include <gtest/gtest.h>
#include <malloc.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "faults/figure.h"
#include "net/admission.h"
#include "net/memory_trim.h"
#include "net/process_figures.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

double resident_mib() {
  return static_cast<double>(net::read_process_figures().resident_bytes) / (1024.0 * 1024.0);
}

TEST(Memory, LargeFramesLeaveNothingBehind) {
  net::share_one_heap();  // as amalgam-server does
  net::ServerConfig config = test_config();
  config.connections.per_address = 64;
  // The sessions stay, silent as they are: one that ends gives all back.
  config.session.idle_timeout = config.session.write_timeout = std::chrono::minutes(1);
  TestServer server(config);
  std::vector<TestClient> clients;
  for (int i = 0; i < 32; ++i) clients.push_back(server.session());
  const std::string jpeg(4'000'000, 'j');
  // What the first frame of all brings with it, code and the tests' own client, is not counted.
  clients.front().send(frame_message(1, jpeg));
  clients.front().expect(Envelope::kComposite);
  ::malloc_trim(0);
  const double before = resident_mib();
  for (TestClient& client : clients) {
    client.send(frame_message(1, jpeg));
    client.expect(Envelope::kComposite);
  }
  const double after = resident_mib();
  double kept = after - before;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (kept > 2.0 && seconds() < 15.0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    kept = resident_mib() - before;
  }
  print_figure("37", "given back after", seconds(), "s", "<= 5 s");
  print_figure("37", "32 sessions keep", kept, "MiB", "<= 2 MiB after 5 s");
  print_figure("37", "right after the frames", after - before, "MiB", "-");
  EXPECT_LE(kept, 2.0);
}

TEST(Memory, ASessionsShareIsKnownAtItsHello) {
  const common::CameraModel camera = common::default_camera(640, 480);
  const std::uint64_t each = net::memory_of_session(camera);
  net::Admission admission({.load = 0.0, .memory = 2 * each});
  EXPECT_FALSE(admission.admit(camera, {}));
  EXPECT_FALSE(admission.admit(camera, {}));
  const auto busy = admission.admit(camera, {});
  ASSERT_TRUE(busy);
  EXPECT_STREQ(busy->label, "memory");
  EXPECT_GT(busy->retry_after.count(), 0);
  admission.leave(camera);
  EXPECT_FALSE(admission.admit(camera, {}));
}

}  // namespace
}  // namespace amalgam::test
