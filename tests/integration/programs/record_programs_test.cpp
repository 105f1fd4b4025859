// A session recorded by one server, asked for in its configuration file, and played to another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "support/child_process.h"
#include "support/record_folder.h"

namespace amalgam::tests {
namespace {

using std::chrono::seconds;
constexpr seconds kPatience(60);

class RecordingServer {
 public:
  explicit RecordingServer(std::vector<std::string> arguments)
      : process_("amalgam-server", with_ports(std::move(arguments))) {
    const std::string line = process_.read_line(kPatience);  // listening on A:P admin A:P
    const std::string begin = "listening on ";
    address_ = line.substr(begin.size(), line.find(" admin ") - begin.size());
  }
  const std::string& address() const { return address_; }
  int end() {
    process_.signal(SIGTERM);
    return process_.wait(kPatience);
  }

 private:
  static std::vector<std::string> with_ports(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(),
                     {"--listen", "127.0.0.1:0", "--admin", "127.0.0.1:0", "--log-level", "warn",
                      "--renderer", "raytrace", "--max-load", "0", "--scene",
                      AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf"});
    return arguments;
  }

  ChildProcess process_;
  std::string address_;
};

TEST(RecordPrograms, ASessionIsRecordedAndPlayedAgain) {
  const test::RecordFolder folder;
  const std::string config = folder.path() / "server.toml";
  std::ofstream(config) << "record-sessions = \"" << folder.path().string()
                        << "\"\nrecord-session-size = 1\n";
  {
    RecordingServer server({"--config", config});
    ChildProcess load("amalgam-load", {"--server", server.address(), "--frames", "4", "--rate",
                                       "20", "--size", "64x48", "--moving"});
    load.read_all(kPatience);
    EXPECT_EQ(load.wait(kPatience), 0);
    EXPECT_EQ(server.end(), 0);
  }
  const auto files = folder.closed(1);
  ASSERT_EQ(files.size(), 1u);
  const auto replay = [&](std::vector<std::string> server_arguments, int expected) {
    RecordingServer server(std::move(server_arguments));
    ChildProcess load("amalgam-load", {"--server", server.address(), "--replay", files[0],
                                       "--as-fast-as-possible"});
    const std::string said = load.read_all(kPatience);
    EXPECT_EQ(load.wait(kPatience), expected) << said;
    return nlohmann::json::parse(said);
  };
  const auto same = replay({}, 0);
  EXPECT_EQ(same["different"], 0);
  EXPECT_EQ(same["equal"], same["frames"]);
  EXPECT_GT(same["frames"], 0);
  EXPECT_TRUE(same["server_differs"].empty()) << same["server_differs"];
  EXPECT_GT(replay({"--samples", "4"}, 1)["different"], 0);
}

}  // namespace
}  // namespace amalgam::tests
