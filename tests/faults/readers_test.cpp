// Row 9: a reader that stops is noticed, whatever buffers there are between us and it.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "support/net/each_transport.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using Clock = std::chrono::steady_clock;

class Readers : public EachTransport {};

TEST_P(Readers, WhoStopsFindsTwoFramesAndIsEvicted) {
  net::ServerConfig config = test_config();
  // A third of the real time, to keep the test short; the ratio is what is promised.
  config.session.write_timeout = std::chrono::milliseconds(1500);
  TestServer server(config, GetParam());
  ControlClient control(server.server().address());
  TestClient client = server.session();  // with the kernel's own buffers, which take megabytes
  const std::string jpeg(50'000, 'j');
  const auto begin = Clock::now();
  bool open = true;
  for (std::uint64_t id = 1; open && Clock::now() - begin < std::chrono::seconds(10); ++id) {
    // Frames keep coming, so it is not silent.
    client.send(frame_message(id, jpeg));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    open = !server.service.wait_views(1, std::chrono::milliseconds(0));
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::size_t held = 0;
  try {
    while (const auto envelope = client.receive()) held += envelope->has_composite() ? 1 : 0;
  } catch (const std::runtime_error&) {
  }
  const auto felt = control.end();
  print_figure("9", "evicted after", seconds / 1.5, "write time-outs", "<= 1.1");
  print_figure("9", "frames held", static_cast<double>(held), "", "<= 2");
  EXPECT_GE(seconds, 1.4);
  EXPECT_LT(seconds, 5.0);
  EXPECT_LE(held, 2u);
  EXPECT_FALSE(felt.lost);
}

// Being slow is no reason to be evicted: each pong opens the way for the next frame.
TEST_P(Readers, WhoReadsSlowlyGetsTheNewest) {
  net::ServerConfig config = test_config();
  config.session.write_timeout = std::chrono::milliseconds(1000);
  TestServer server(config, GetParam());
  TestClient client = server.session();
  std::uint64_t sent = 0, last = 0, received = 0;
  const auto begin = Clock::now();
  while (Clock::now() - begin < std::chrono::milliseconds(1500)) {
    for (int i = 0; i < 5; ++i) client.send(frame_message(++sent));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    last = client.expect(Envelope::kComposite).composite().frame_id();
    ++received;
  }
  EXPECT_GE(received, 5u);
  // Two on their way, one waiting, one being rendered, and five just sent.
  EXPECT_LE(sent - last, 15u);
}

INSTANTIATE_TEST_SUITE_P(Over, Readers, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
