// What a service manager and a load balancer hear of the server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <string>

#include "support/net/notify_socket.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using testing::HasSubstr;
using namespace std::chrono_literals;

TEST(Supervision, SystemdHearsOfReadinessLifeReloadsAndTheEnd) {
  NotifySocket systemd;
  TestServer server;
  EXPECT_TRUE(systemd.hears("READY=1"));
  EXPECT_TRUE(systemd.hears("WATCHDOG=1"));
  server.server().drain();
  EXPECT_TRUE(systemd.hears("STOPPING=1"));
}

TEST(Supervision, AReloadIsSaidAndEndsHoweverItEnds) {
  NotifySocket systemd;
  StubFrameService service;
  net::Server server(test_config());
  server.handle_signals([&] { server.reload_ended("a broken scene"); });
  server.serve(service);
  std::thread thread([&] { server.run(); });
  ASSERT_TRUE(systemd.hears("READY=1"));
  ::kill(::getpid(), SIGHUP);
  EXPECT_TRUE(systemd.hears("RELOADING=1\nMONOTONIC_USEC="));
  EXPECT_TRUE(systemd.hears("READY=1"));
  server.stop();
  thread.join();
}

TEST(Supervision, TheWatchdogHearsNothingOfAStuckRenderer) {
  NotifySocket systemd;
  TestServer server;
  ASSERT_TRUE(systemd.hears("READY=1"));
  ASSERT_TRUE(systemd.hears("WATCHDOG=1"));
  frame::ServiceLoad stuck;
  stuck.without_progress = 1h;
  server.service.set_load(stuck);
  while (!systemd.next(1ms).empty()) {  // said before
  }
  EXPECT_EQ(systemd.next(1200ms), "");  // two ticks long
  server.service.set_load({});
  EXPECT_TRUE(systemd.hears("WATCHDOG=1"));
}

class Agent : public testing::Test {
 protected:
  static net::ServerConfig config() {
    net::ServerConfig config = test_config();
    config.agent = {"127.0.0.1", 0};
    config.drain_delay = 300ms;
    config.connections.total = 10;
    return config;
  }
  static std::string ask(const net::Server& server) { return read_to_end(*server.agent_address()); }
};

TEST_F(Agent, TellsWhatIsFreeOfTheScarcestResource) {
  TestServer server(config());
  EXPECT_EQ(ask(server.server()), "ready up 100%\n");
  frame::ServiceLoad load;
  load.demand = protocol::kMaxLoad / 4.0;
  server.service.set_load(load);
  EXPECT_EQ(ask(server.server()), "ready up 75%\n");
  std::deque<TestClient> clients;
  for (int i = 0; i < 5; ++i) clients.push_back(server.session());
  EXPECT_EQ(ask(server.server()), "ready up 50%\n");
  // A full server says Busy itself; with a weight of 0 the balancer would refuse.
  load.demand = 3.0;
  server.service.set_load(load);
  EXPECT_EQ(ask(server.server()), "ready up 1%\n");
}

TEST_F(Agent, DrainsWhileLoadingAndLeavingAndServesMeanwhile) {
  {
    net::Server loading(config());
    std::thread thread([&] { loading.run(); });
    EXPECT_EQ(ask(loading), "drain\n");
    loading.stop();
    thread.join();
  }
  TestServer server(config());
  TestClient before = server.session();
  const auto begin = std::chrono::steady_clock::now();
  server.server().drain();
  EXPECT_EQ(server.admin("/readyz").status, 503);
  EXPECT_EQ(server.admin("/livez").status, 200);
  EXPECT_EQ(ask(server.server()), "drain\n");
  TestClient late = server.session();  // the balancer has not noticed yet
  late.send(frame_message(1));
  EXPECT_EQ(late.expect(Envelope::kComposite).composite().frame_id(), 1u);
  before.expect(Envelope::kDraining);
  late.expect(Envelope::kDraining);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 300ms);
  EXPECT_THROW(server.connect(), std::runtime_error);
  EXPECT_TRUE(before.closed_by_server());
  EXPECT_TRUE(late.closed_by_server());
  server.join();
}

}  // namespace
}  // namespace amalgam::test
