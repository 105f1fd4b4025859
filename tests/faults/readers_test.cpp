// Rows 9 and 10: a reader that stops is noticed, whatever buffers there are between us and it; one
// that is slow gets fewer frames, and new ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <vector>

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

// Composites of a tenth of a second's transfer each, asked for fifty times a second.
TEST(ReadersOverTcp, AMegabitASecondGetsFewerFramesAndNewOnes) {
  constexpr double kBytesPerSecond = 125'000.0, kTransfer = 0.1;  // seconds
  constexpr auto kTick = std::chrono::milliseconds(20);
  net::ServerConfig config = test_config();
  config.session.write_timeout = std::chrono::milliseconds(600);
  TestServer server(config);
  const ControlClient::Felt alone = ControlClient::feel_alone(server.server().address());
  ControlClient control(server.server().address());
  TestClient client = server.session();
  const std::string jpeg(static_cast<std::size_t>(kBytesPerSecond * kTransfer), 'j');
  std::map<std::uint64_t, Clock::time_point> sent;
  std::uint64_t last_sent = 0;
  const auto begin = Clock::now();
  auto next = begin;
  // A link's rate: what a late tick has missed is made up for by the following ones.
  client.read_slowly(static_cast<std::size_t>(kBytesPerSecond * 0.02), [&] {
    next += kTick;
    std::this_thread::sleep_until(next);
    sent[++last_sent] = Clock::now();
    client.send(frame_message(last_sent, jpeg));
  });
  std::vector<double> ages;  // seconds, of composites when they have arrived
  std::uint64_t last = 0;
  while (Clock::now() - begin < std::chrono::milliseconds(1800)) {
    const auto composite = client.expect(Envelope::kComposite).composite();
    EXPECT_GT(composite.frame_id(), last);
    last = composite.frame_id();
    ages.push_back(std::chrono::duration<double>(Clock::now() - sent.at(last)).count());
  }
  const double rate = static_cast<double>(ages.size()) /
                      std::chrono::duration<double>(Clock::now() - begin).count();
  std::ranges::sort(ages);
  const double oldest = ages.back(), usual = ages[ages.size() * 9 / 10];
  const auto felt = control.end();
  print_figure("10", "composites a second of 50 frames", rate, "", "what the link carries, 10");
  print_figure("10", "age of nine in ten composites", usual / kTransfer, "transfer times", "<= 2");
  print_figure("10", "age of the oldest composite", oldest / kTransfer, "transfer times", "<= 2");
  expect_unharmed("10", alone, felt);
  EXPECT_GT(rate, 6.0);
  EXPECT_LT(rate, 12.0);
  // One on its way, and the period of the frames, of which the newest is chosen. Ticks come late on
  // a busy machine, so the oldest of all has some room.
  EXPECT_LT(usual, 2.0 * kTransfer);
  EXPECT_LT(oldest, 2.0 * kTransfer + 0.15);
  EXPECT_TRUE(server.service.wait_views(1, std::chrono::milliseconds(1000)))
      << "evicted, or control stays";
}

INSTANTIATE_TEST_SUITE_P(Over, Readers, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
