#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <tuple>

#include "codec/jpeg.h"
#include "codec/picture.h"
#include "support/child_process.h"
#include "support/test_data.h"

namespace amalgam::tests {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;
constexpr seconds kPatience(120);  // llvmpipe on a busy machine

std::string scene_path(const std::string& name) {
  return AMALGAM_SOURCE_DIR "/deploy/scenes/" + name + ".gltf";
}

// A folder for one test's files, gone with it.
class Programs : public testing::Test {
 protected:
  Programs()
      : folder_(fs::temp_directory_path() /
                ("amalgam-programs-" + std::to_string(getpid()) + "-" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~Programs() override { fs::remove_all(folder_); }

  static std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // A picture without any marker.
  fs::path write_plain_jpeg() const {
    const auto jpeg =
        codec::encode_jpeg(common::ImageRgb8(320, 240, common::Rgb8(90, 120, 150)), 85);
    fs::path path = folder_ / "plain.jpg";
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(jpeg.data()),
               static_cast<std::streamsize>(jpeg.size()));
    return path;
  }

  fs::path folder_;
};

// A server on ports of its own; ended by SIGTERM it must exit with 0.
class Server {
 public:
  explicit Server(const std::string& scene)
      : process_("amalgam-server", {"--scene", scene, "--listen", "127.0.0.1:0", "--admin",
                                    "127.0.0.1:0", "--log-level", "warn"}) {
    const std::string line = process_.read_line(kPatience);  // listening on A:P admin A:P
    const std::string begin = "listening on ", middle = " admin ";
    const std::size_t at = line.find(middle);
    if (line.rfind(begin, 0) == 0 && at != std::string::npos) {
      address_ = line.substr(begin.size(), at - begin.size());
    }
  }
  const std::string& address() const { return address_; }
  int end() {
    process_.signal(SIGTERM);
    return process_.wait(seconds(25));
  }

 private:
  ChildProcess process_;
  std::string address_;
};

nlohmann::json run_client(const Server& server, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"--server", server.address(), "--json"});
  ChildProcess client("amalgam-client", std::move(arguments));
  const std::string text = client.read_all(kPatience);
  EXPECT_EQ(client.wait(seconds(10)), 0) << text;
  return nlohmann::json::parse(text, nullptr, false);
}

TEST_F(Programs, SyntheticFramesAreCompositedOrCounted) {
  Server server(scene_path("complex"));
  ASSERT_FALSE(server.address().empty());
  const nlohmann::json summary =
      run_client(server, {"--synthetic", "--size", "320x240", "--frames", "20", "--rate", "30",
                          "--output", (folder_ / "out").string()});
  ASSERT_TRUE(summary.is_object());
  const auto& frames = summary["frames"];
  EXPECT_EQ(frames["captured"], 20);
  EXPECT_GT(frames["composited"].get<int>(), 0);
  EXPECT_EQ(frames["composited"].get<int>() + frames["skipped_by_client"].get<int>() +
                frames["skipped_by_server"].get<int>(),
            20)
      << summary;
  int written = 0;
  for (const auto& file : fs::directory_iterator(folder_ / "out")) {
    const std::string bytes = read_file(file.path());
    const common::ImageRgb8 image = codec::decode_jpeg(std::as_bytes(std::span(bytes)));
    EXPECT_EQ(image.size(), glm::ivec2(320, 240));
    ++written;
  }
  EXPECT_EQ(written, frames["composited"].get<int>());
  EXPECT_EQ(server.end(), 0);
}

// The invariant, seen from outside: without a marker the bytes that went are the bytes that come.
TEST_F(Programs, WithoutAMarkerTheBytesComeBack) {
  Server server(scene_path("complex"));
  ASSERT_FALSE(server.address().empty());
  const fs::path picture = write_plain_jpeg();
  const nlohmann::json summary =
      run_client(server, {"--images", picture.string(), "--frames", "1", "--lockstep", "--output",
                          (folder_ / "out").string()});
  EXPECT_EQ(summary["frames"]["unchanged"], 1) << summary;
  EXPECT_EQ(read_file(folder_ / "out" / "frame-000001.jpg"), read_file(picture));
  EXPECT_EQ(server.end(), 0);
}

TEST_F(Programs, PhotographGetsItsObjects) {
  const auto data = test_data();
  if (!data) GTEST_SKIP() << "no test data beside the source folder";
  const fs::path photographs = *data / "real_markers" / "opencv_contrib";
  ChildProcess render(
      "amalgam-render",
      {"--scene", scene_path("complex"), "--camera-image",
       (photographs / "singlemarkersoriginal.jpg").string(), "--calibration",
       (photographs / "tutorial_camera_params.yml").string(), "--output",
       (folder_ / "out.png").string(), "--dump", (folder_ / "d").string(), "--json"});
  const nlohmann::json report = nlohmann::json::parse(render.read_all(kPatience), nullptr, false);
  EXPECT_EQ(render.wait(seconds(10)), 0);
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["nonfinite"], 0);
  EXPECT_FALSE(report["unchanged"].get<bool>());
  EXPECT_GT(report["pixels"]["specular"].get<int>(), 1000);
  EXPECT_GT(report["rays"]["refraction"].get<int>(), 1000);
  EXPECT_TRUE(fs::exists(folder_ / "out.png"));
  EXPECT_TRUE(fs::exists(folder_ / "d" / "mixed.exr"));
}

// A scene on another marker than the picture's would otherwise just be missing.
TEST_F(Programs, PosesOfOtherMarkersGiveAWarning) {
  const fs::path poses = folder_ / "poses.json";
  std::ofstream(poses)
      << R"({"poses":[{"marker":3,"rotation":[1,0,0,0],"translation":[0,0,0.4]}]})";
  ChildProcess render("amalgam-render",
                      {"--scene", scene_path("complex"), "--poses", poses.string(), "--size",
                       "32x24", "--output", (folder_ / "out.png").string()},
                      ChildProcess::Reads::OutputAndErrors);
  const std::string said = render.read_all(kPatience);
  EXPECT_EQ(render.wait(seconds(10)), 0);
  EXPECT_NE(said.find("no marker of the scene among the poses (3): its world_marker is 40"),
            std::string::npos)
      << said;
}

// The same shares as numbers, as a buffer and as a picture with its legend.
TEST_F(Programs, LightIsAccountedFor) {
  ChildProcess render("amalgam-render", {"--scene", scene_path("complex"), "--size", "160x120",
                                         "--dump", (folder_ / "d").string(), "--json"});
  const nlohmann::json report = nlohmann::json::parse(render.read_all(kPatience), nullptr, false);
  EXPECT_EQ(render.wait(seconds(10)), 0);
  ASSERT_TRUE(report.is_object());
  const nlohmann::json& shares = report["provenance"];
  EXPECT_GT(shares["raster"].get<double>(), 1000.0);
  EXPECT_TRUE(fs::exists(folder_ / "d" / "provenance.exr"));
  const std::string png = read_file(folder_ / "d" / "provenance.png");
  const common::ImageRgba8 picture =
      codec::decode_picture(std::as_bytes(std::span(png.data(), png.size())));
  EXPECT_EQ(picture.width(), 160);
  EXPECT_GT(picture.height(), 120);
  const auto pixels = picture.pixels().first(160 * 120);
  const auto green = std::count_if(pixels.begin(), pixels.end(), [](const common::Rgba8& p) {
    return p.g > p.r + 60 && p.g > p.b + 60;
  });
  EXPECT_NEAR(static_cast<double>(green), shares["camera_lookup"].get<double>(),
              0.3 * shares["camera_lookup"].get<double>());
}

// The report has the poses that were used, and --poses takes them again.
TEST_F(Programs, TheReportSaysThePosesUsed) {
  const auto report_of = [&](const std::string& poses) {
    const fs::path file = folder_ / "poses.json";
    std::ofstream(file) << poses;
    ChildProcess render("amalgam-render",
                        {"--renderer", "raytrace", "--scene", scene_path("diffuse"), "--size",
                         "32x24", "--poses", file.string(), "--json"});
    auto report = nlohmann::json::parse(render.read_all(kPatience), nullptr, false);
    EXPECT_EQ(render.wait(seconds(10)), 0);
    return report;
  };
  const nlohmann::json given = {
      {{"marker", 40}, {"rotation", {0.8, 0.0, 0.6, 0.0}}, {"translation", {0.01, -0.02, 0.5}}},
      {{"marker", 7}, {"rotation", {0.0, 1.0, 0.0, 0.0}}, {"translation", {0.25, 0.0, 1.0 / 3.0}}}};
  const nlohmann::json report = report_of(nlohmann::json{{"poses", given}}.dump());
  ASSERT_TRUE(report.contains("poses"));
  EXPECT_EQ(report["poses"], given);
  EXPECT_EQ(report_of(report.dump())["poses"], given);
}

TEST_F(Programs, BadOptionsGiveOneLineAndAFailure) {
  for (const auto& [program, arguments, says] :
       std::vector<std::tuple<std::string, std::vector<std::string>, std::string>>{
           {"amalgam-server", {"--scene", "/nowhere.gltf", "--log-level", "error"}, "nowhere"},
           {"amalgam-server", {"--listen", "nonsense"}, "nonsense"},
           {"amalgam-server", {"--max-load", "nan"}, "--max-load"},
           {"amalgam-render", {"--samples", "7"}, "--samples"},
           {"amalgam-render", {"--camera-image", "/nowhere.jpg"}, "nowhere"},
           {"amalgam-render", {"--camera-image", "/tmp"}, "/tmp: is a folder"},
           {"amalgam-render", {"--target-fps", "nan"}, "--target-fps"},
           {"amalgam-render", {"--size", "9000x2"}, "9000x2"},
           // Before anything is loaded and rendered for it.
           {"amalgam-render", {"--scene", "/nowhere.gltf", "--output", "a.gif"}, ".png or .jpg"},
           {"amalgam-render", {"--bogus"}, "--bogus"},
           {"amalgam-inspect", {"--bogus", "scene.gltf"}, "--bogus"},
           {"amalgam-marker", {"--bogus"}, "--bogus"},
           {"amalgam-load", {"--bogus"}, "--bogus"},
           {"amalgam-client", {"--synthetic", "--bogus"}, "--bogus"},
           {"amalgam-client",
            {"--server", "127.0.0.1:1", "--synthetic", "--connect-timeout", "0.5"},
            "127.0.0.1:1"}}) {
    ChildProcess process(program, arguments, ChildProcess::Reads::OutputAndErrors);
    const std::string text = process.read_all(kPatience);
    EXPECT_EQ(process.wait(kPatience), 1) << program << " " << arguments.front();
    EXPECT_EQ(text.find(program + ": "), 0u) << text;
    EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
    EXPECT_NE(text.find(says), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace amalgam::tests
