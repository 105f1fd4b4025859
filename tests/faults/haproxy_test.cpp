// Row 29: two servers behind HAProxy, by the configuration that operators get. One drains, or dies.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "client/tools/load/load_image.h"
#include "faults/figure.h"
#include "faults/roaming_clients.h"
#include "faults/server_process.h"
#include "support/child_process.h"
#include "support/net/test_client.h"

namespace amalgam::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kHaproxy = "/usr/sbin/haproxy";
constexpr std::size_t kClients = 32;
// HAProxy asks the agents twice a second.
constexpr auto kOneInterval = 700ms;

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

// A port that was free just now.
common::HostPort free_address() {
  const int handle = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  EXPECT_EQ(::bind(handle, any, size), 0);
  ::getsockname(handle, any, &size);
  ::close(handle);
  return {"127.0.0.1", ntohs(address.sin_port)};
}

class Haproxy : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kHaproxy)) GTEST_SKIP() << "haproxy is not installed";
    std::ifstream file(AMALGAM_SOURCE_DIR "/deploy/haproxy/haproxy.cfg");
    std::stringstream text;
    text << file.rdbuf();
    std::string config = text.str();
    replace(config, "bind 10.0.0.5:7447", "bind " + to_string(address_));
    replace(config, "server a 10.0.0.11:7447", server_line("a", a_));
    replace(config, "server b 10.0.0.12:7447", server_line("b", b_));
    std::ofstream(config_) << config;
    haproxy_ = std::make_unique<tests::ChildProcess>(
        kHaproxy, std::vector<std::string>{"-db", "-f", config_});
    wait_for_haproxy();
  }
  void TearDown() override { fs::remove(config_); }

  static std::string server_line(const std::string& name, const ServerProcess& server) {
    return "server " + name + " " + to_string(server.address()) + " port " +
           std::to_string(server.admin_address().port) + " agent-port " +
           std::to_string(server.agent_address().port);
  }
  void wait_for_haproxy() const {
    for (int i = 0; i < 200; ++i) {
      try {
        TestClient client(address_);
        return;
      } catch (const std::runtime_error&) {
        std::this_thread::sleep_for(20ms);
      }
    }
    FAIL() << "haproxy does not serve";
  }
  static std::size_t sessions(const ServerProcess& server) {
    const std::string text = http_get(server.admin_address(), "/metrics").body;
    return std::stoul(text.substr(text.find("\namalgam_sessions ") + 18));
  }
  static void print(const std::string& what, const RoamingClients::Felt& felt) {
    print_figure("29", what + ": refused", static_cast<double>(felt.refused), "connections", "0");
    print_figure("29", what + ": longest gap", felt.longest_gap_s, "s", "<= 1 s");
  }

  static std::vector<std::string> options() {
    const std::string scene = AMALGAM_SOURCE_DIR "/deploy/scenes/diffuse.gltf";
    return {"--scene",         scene,       "--agent-check",     "127.0.0.1:0",
            "--trusted-proxy", "127.0.0.1", "--max-per-address", "64",
            "--max-load",      "0",         "--drain-delay",     "1.5",
            "--log-level",     "warn"};
  }
  ServerProcess a_{options(), STDERR_FILENO}, b_{options(), STDERR_FILENO};
  common::HostPort address_ = free_address();
  std::string config_ = fs::temp_directory_path() / ("haproxy-" + std::to_string(::getpid()));
  std::unique_ptr<tests::ChildProcess> haproxy_;
  const std::string jpeg_ = load::grey_image(640, 480).jpeg;
};

TEST_F(Haproxy, OneServerDrains) {
  RoamingClients clients(address_, kClients, jpeg_);
  ASSERT_TRUE(clients.all_served());
  EXPECT_EQ(sessions(a_) + sessions(b_), kClients);
  EXPECT_GT(sessions(a_), kClients / 4);
  EXPECT_GT(sessions(b_), kClients / 4);
  a_.signal(SIGTERM);
  std::this_thread::sleep_for(kOneInterval);
  // It still serves, but newcomers go to the other one.
  const std::size_t on_a = sessions(a_), on_b = sessions(b_);
  std::deque<TestClient> newcomers;
  for (int i = 0; i < 8; ++i) {
    newcomers.emplace_back(address_).send(hello_message());
    newcomers.back().expect(protocol::Envelope::kWelcome);
  }
  EXPECT_EQ(sessions(a_), on_a);
  EXPECT_EQ(sessions(b_), on_b + 8);
  EXPECT_GE(a_.wait(25s), 0.0);
  EXPECT_EQ(a_.exit_code(), 0);
  EXPECT_TRUE(clients.all_served());
  EXPECT_EQ(sessions(b_), kClients + 8);
  const RoamingClients::Felt felt = clients.end();
  print("a server drains", felt);
  EXPECT_EQ(felt.refused, 0u);
  EXPECT_EQ(felt.returns, on_a);
  EXPECT_LE(felt.longest_gap_s, 1.0);
}

TEST_F(Haproxy, OneServerDies) {
  RoamingClients clients(address_, kClients, jpeg_);
  ASSERT_TRUE(clients.all_served());
  const std::size_t on_a = sessions(a_);
  EXPECT_GT(on_a, kClients / 4);
  a_.signal(SIGKILL);
  EXPECT_TRUE(clients.all_served());
  EXPECT_EQ(sessions(b_), kClients);
  const RoamingClients::Felt felt = clients.end();
  print("a server dies", felt);
  EXPECT_EQ(felt.refused, 0u);
  EXPECT_EQ(felt.returns, on_a);
  EXPECT_LE(felt.longest_gap_s, 1.0);
}

}  // namespace
}  // namespace amalgam::test
