// Rows 22, 23, 30 and 31 with the program itself: standard error, signals and configuration.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "faults/figure.h"
#include "faults/server_process.h"
#include "protocol/session_record.h"
#include "support/child_process.h"
#include "support/net/test_client.h"

namespace amalgam::test {
namespace {

namespace fs = std::filesystem;
using protocol::Envelope;
using testing::HasSubstr;
using namespace std::chrono_literals;

const std::string kScenes = AMALGAM_SOURCE_DIR "/deploy/scenes/";

class ServerProgram : public testing::Test {
 protected:
  ServerProgram()
      : folder_(fs::temp_directory_path() / ("amalgam-faults-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    null_ = ::open("/dev/null", O_WRONLY);
  }
  ~ServerProgram() override {
    ::close(null_);
    fs::remove_all(folder_);
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    fs::permissions(folder_ / name, fs::perms::owner_read | fs::perms::owner_write);
    return folder_ / name;
  }
  // What the program says when it refuses to start.
  static std::string refusal(std::vector<std::string> arguments) {
    if (std::ranges::find(arguments, "--admin") == arguments.end()) {
      arguments.insert(arguments.end(), {"--admin", "127.0.0.1:0"});
    }
    arguments.insert(arguments.end(), {"--scene", kScenes + "diffuse.gltf"});
    tests::ChildProcess process("amalgam-server", std::move(arguments),
                                tests::ChildProcess::Reads::OutputAndErrors);
    std::string said = process.read_all(std::chrono::seconds(10));
    EXPECT_GT(process.wait(std::chrono::seconds(10)), 0);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_LT(said.size(), 300u) << said;
    return said;
  }

  fs::path folder_;
  int null_ = -1;
};

TEST_F(ServerProgram, AStandardErrorThatNobodyReadsStopsNothing) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ServerProcess server({"--scene", kScenes + "diffuse.gltf", "--max-per-address", "1000"}, ends[1]);
  for (int i = 0; i < 1000; ++i) {
    TestClient client(server.address());
    client.send(frame_message(1));  // no hello
    while (client.receive()) {
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(http_get(server.admin_address(), "/livez").status, 200);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  server.signal(SIGTERM);
  const double ended = server.wait(25s);
  print_figure("30", "/livez after 1000 refused hellos took", 1000.0 * seconds, "ms",
               "nothing else notices");
  print_figure("23", "SIGTERM with a stuck log ended it after", ended, "s", "<= 25 s");
  EXPECT_LT(seconds, 1.0);
  EXPECT_GE(ended, 0.0);
  EXPECT_EQ(server.exit_code(), 0);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(ServerProgram, AClosedStandardErrorStaysClosed) {
  ServerProcess server({"--scene", kScenes + "diffuse.gltf"}, -1);
  TestClient client(server.address());
  client.send(frame_message(1));
  client.expect_error(protocol::Error::UNEXPECTED_MESSAGE);
  const std::string link = "/proc/" + std::to_string(server.id()) + "/fd/2";
  EXPECT_EQ(fs::read_symlink(link), "/dev/null");
  server.signal(SIGTERM);
  EXPECT_GE(server.wait(25s), 0.0);
  EXPECT_EQ(server.exit_code(), 0);
}

// Of all its threads.
double cpu_seconds(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  // Fields 14 and 15; the second is the name, which may have spaces.
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0.0, system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

TEST_F(ServerProgram, WithoutFreeDescriptorsItWaitsAndServesWhomItHas) {
  ServerProcess server({"--scene", kScenes + "diffuse.gltf", "--max-per-address", "1000",
                        "--max-unauthenticated", "1000", "--max-load", "0"},
                       null_);
  TestClient client(server.address());
  client.send(hello_message());
  client.expect(Envelope::kWelcome);
  const rlimit few{64, 64};
  ASSERT_EQ(::prlimit(server.id(), RLIMIT_NOFILE, &few, nullptr), 0);
  {
    std::vector<TestClient> others;
    for (int i = 0; i < 100; ++i) others.emplace_back(server.address());
    std::this_thread::sleep_for(300ms);
    const double before = cpu_seconds(server.id());
    std::this_thread::sleep_for(1200ms);
    const double share = (cpu_seconds(server.id()) - before) / 1.2;
    print_figure("22", "processor time without free descriptors", 100.0 * share, "%", "< 5 %");
    EXPECT_LT(share, 0.05);
    const auto descriptors =
        std::distance(fs::directory_iterator("/proc/" + std::to_string(server.id()) + "/fd"), {});
    EXPECT_GE(descriptors, 64) << "there were free ones";
    Envelope ping;
    ping.mutable_ping()->set_nonce(22);
    const auto begin = std::chrono::steady_clock::now();
    client.send(ping);
    EXPECT_EQ(client.expect(Envelope::kPong).pong().nonce(), 22u);
    const double answered =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    print_figure("22", "a session's ping answered after", 1000.0 * answered, "ms", "goes on");
    EXPECT_LT(answered, 1.0);
  }
  TestClient newcomer(server.address());
  newcomer.send(hello_message());
  newcomer.expect(Envelope::kWelcome);
  server.signal(SIGTERM);
  EXPECT_GE(server.wait(25s), 0.0);
  EXPECT_EQ(server.exit_code(), 0);
}

int world_marker(const common::HostPort& server) {
  TestClient client(server);
  client.send(hello_message());
  return client.expect(Envelope::kWelcome).welcome().markers().world_marker();
}

TEST_F(ServerProgram, SighupReloadsOrKeepsTheOld) {
  const std::string scene = (folder_ / "scene.gltf").string();
  const auto place = [&](const std::string& name) {
    for (const auto& entry : fs::directory_iterator(kScenes)) {
      if (entry.is_regular_file() && entry.path().extension() != ".gltf") {
        fs::copy_file(entry.path(), folder_ / entry.path().filename(),
                      fs::copy_options::overwrite_existing);
      }
    }
    fs::copy_file(kScenes + name, scene, fs::copy_options::overwrite_existing);
  };
  place("diffuse.gltf");
  const std::string config = write("server.toml", "max-per-address = 8\n");
  ServerProcess server({"--scene", scene, "--config", config, "--max-load", "0"}, null_);
  TestClient open(server.address());
  open.send(hello_message());
  open.expect(Envelope::kWelcome);
  const auto reloads = [&](const std::string& result, int count) {
    const std::string line =
        "amalgam_reloads_total{result=\"" + result + "\"} " + std::to_string(count) + "\n";
    for (int i = 0; i < 500; ++i) {
      const std::string text = http_get(server.admin_address(), "/metrics").body;
      if (text.find(line) != std::string::npos) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  };
  const int marker = world_marker(server.address());
  // A broken scene, a mistyped key, and then all is well.
  std::ofstream(scene) << "{ broken";
  server.signal(SIGHUP);
  EXPECT_TRUE(reloads("kept_the_old", 1));
  place("diffuse.gltf");
  write("server.toml", "max_per_address = 8\n");
  server.signal(SIGHUP);
  EXPECT_TRUE(reloads("kept_the_old", 2));
  EXPECT_EQ(world_marker(server.address()), marker);
  const auto state = [&] { return http_get(server.admin_address(), "/state").body; };
  EXPECT_THAT(state(), HasSubstr("\"admin_pictures\": false"));
  write("server.toml", "max-per-address = 1\nadmin-pictures = true\n");
  const auto begin = std::chrono::steady_clock::now();
  server.signal(SIGHUP);
  EXPECT_TRUE(reloads("done", 1));
  print_figure("b", "SIGHUP took over scene and limits after",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), "s",
               "at a frame boundary");
  EXPECT_THAT(state(), HasSubstr("\"admin_pictures\": true"));
  // The session that was open goes on, and the new limit holds for others.
  Envelope ping;
  ping.mutable_ping()->set_nonce(5);
  open.send(ping);
  EXPECT_EQ(open.expect(Envelope::kPong).pong().nonce(), 5u);
  TestClient second(server.address());
  EXPECT_TRUE(second.receive().value_or(Envelope()).has_busy());
  EXPECT_TRUE(server.is_running());
  server.signal(SIGTERM);
  EXPECT_GE(server.wait(25s), 0.0);
  EXPECT_EQ(server.exit_code(), 0);
}

TEST_F(ServerProgram, WhatCannotBeMeantIsRefusedInOneLine) {
  EXPECT_THAT(refusal({"--config", write("a.toml", "token_file = \"secret\"\n")}),
              HasSubstr("token_file"));
  EXPECT_THAT(refusal({"--token-file", write("latin1", "caf\xe9\n")}), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal({"--token-file", write("empty", "\n")}), HasSubstr("empty"));
  const std::string open_file = write("open", "secret\n");
  fs::permissions(open_file, fs::perms::all);
  EXPECT_THAT(refusal({"--token-file", open_file}), HasSubstr("everybody"));
  EXPECT_THAT(refusal({"--threads", "x"}), HasSubstr("--threads"));
  EXPECT_THAT(refusal({"--listen", "0.0.0.0:0"}), HasSubstr("--insecure"));
  EXPECT_THAT(refusal({"--admin-pictures", "--admin", "0.0.0.0:0"}), HasSubstr("pictures"));
  EXPECT_THAT(refusal({"--tls-certificate", "/nonexistent.crt"}), HasSubstr("certificate"));
  EXPECT_THAT(refusal({"--environment-from", "somebody"}), HasSubstr("environment-from"));
}

// As a disk on which there is no more room: files may not grow any further.
TEST_F(ServerProgram, AFullDiskEndsTheRecordAndNothingElse) {
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100'000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);  // the child takes it over
  ServerProcess server({"--scene", kScenes + "diffuse.gltf", "--record-sessions", folder_.string()},
                       null_);
  ::setrlimit(RLIMIT_FSIZE, &before);
  TestClient client(server.address());
  client.send(hello_message());
  client.expect(Envelope::kWelcome);
  for (std::uint64_t id = 1; id <= 20; ++id) {
    client.send(frame_message(id, std::string(20'000, 'x')));
    client.expect_error(protocol::Error::BAD_IMAGE);
  }
  EXPECT_THAT(http_get(server.admin_address(), "/state").body, HasSubstr("\"failed\": 1"));
  EXPECT_TRUE(server.is_running());
  std::size_t frames = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    protocol::SessionRecordReader reader(entry.path());
    while (const auto record = reader.next()) frames += record->has_submitted() ? 1 : 0;
    EXPECT_FALSE(reader.was_cut());
  }
  EXPECT_EQ(frames, 4u);  // as many as have room
}

}  // namespace
}  // namespace amalgam::test
