#include "frame/replay_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const common::MarkerPose kPose = {40, {0.5, -0.5, 0.5, -0.5}, {0.1, -0.25, 1.0 / 3.0}};
const std::string kWithoutPicture =
    "\n# the camera's picture is not kept; if you have it: --camera-image instead of --size";

ReplayedFrame plain_frame() {
  return {.scene_path = "/scenes/a.gltf", .camera = common::default_camera(64, 48)};
}

TEST(ReplayText, OfAPlainFrameIsShort) {
  const std::string line =
      "echo '{\"poses\":[]}' > poses.json && amalgam-render --scene "
      "/scenes/a.gltf --size 64x48 --poses poses.json";
  EXPECT_EQ(replay_text(plain_frame()), line + kWithoutPicture);
}

TEST(ReplayText, HasPosesToTheBit) {
  ReplayedFrame frame = plain_frame();
  const std::vector<common::MarkerPose> poses = {kPose, {7, {1, 0, 0, 0}, {0, 0, 1}}};
  frame.poses = poses;
  EXPECT_THAT(replay_text(frame),
              StartsWith("echo '{\"poses\":[{\"marker\":40,\"rotation\":[-0.5,0.5,-0.5,0.5],"
                         "\"translation\":[0.1,-0.25,0.3333333333333333]},{\"marker\":7,"
                         "\"rotation\":[0,0,0,1],\"translation\":[0,0,1]}]}' > poses.json"));
}

TEST(ReplayText, NamesTheSettingsThatDiffer) {
  ReplayedFrame frame = plain_frame();
  frame.settings.mode = RendererMode::Raytrace;
  frame.settings.trace.max_depth = 3;
  frame.settings.exposure = 0.5f;
  frame.settings.jpeg_quality = 50;
  const std::string text = replay_text(frame);
  EXPECT_THAT(text, HasSubstr("poses.json --renderer raytrace --max-depth 3 --exposure 0.5\n"));
  EXPECT_THAT(text, EndsWith("\n# without an option: jpeg_quality is 50"));
}

TEST(ReplayText, SaysWhatElseTheFrameWas) {
  ReplayedFrame frame = plain_frame();
  frame.repeat = 3;
  frame.keep_provenance = frame.keep_buffers = frame.environment_replaced = true;
  EXPECT_THAT(replay_text(frame), HasSubstr("--repeat 3 --still --json --dump buffers\n"));
  EXPECT_THAT(replay_text(frame), HasSubstr("\n# a client had replaced the scene's environment"));
}

TEST(ReplayText, AnotherCameraHasACalibration) {
  ReplayedFrame frame = plain_frame();
  frame.camera.fx = 99.5;
  frame.camera.distortion[0] = -1e-5;
  const std::string text = replay_text(frame);
  EXPECT_THAT(text, HasSubstr("' > calibration.json && amalgam-render "));
  EXPECT_THAT(text, HasSubstr("--calibration calibration.json"));
  EXPECT_THAT(text, HasSubstr("\"data\":[99.5,0,31.5,0,"));
  EXPECT_THAT(text, HasSubstr("\"data\":[-1e-05,0,0,0,0,0,0,0,0,0,0,0]"));
  EXPECT_THAT(replay_text(plain_frame()), Not(HasSubstr("calibration")));
}

TEST(ReplayText, PathsAreOneWordOfAShell) {
  ReplayedFrame frame = plain_frame();
  frame.scene_path = "/it's a scene.gltf";
  EXPECT_THAT(replay_text(frame), HasSubstr("--scene '/it'\\''s a scene.gltf' --size"));
  frame.scene_path = "a.gltf";
  EXPECT_THAT(
      replay_text(frame),
      HasSubstr("--scene " + (std::filesystem::current_path() / "a.gltf").string() + " --size"));
  frame.scene_path = "";
  EXPECT_THAT(replay_text(frame), HasSubstr("--scene '<scene>' --size"));
}

TEST(ReplayText, ScenesKnowWhereTheyAreFrom) {
  const std::string path = AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf";
  EXPECT_EQ(scene::load_scene(path).path, path);
}

// The one check that a caller can break.
TEST(ReplayTextDeathTest, ACheckThatFailsInAFramePrintsIt) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  scene::Scene scene;
  scene.path = "/scenes/broken.gltf";
  RendererSettings settings;
  settings.mode = RendererMode::Raytrace;
  settings.trace.max_depth = 3;
  settings.target_fps = 30.0;  // not said: what it has chosen is
  FrameRenderer renderer(std::move(scene), settings);
  ViewState view({.camera = common::default_camera(64, 48), .keep_pixels = true});
  const FrameInput input{common::ImageRgb8(64, 48), {kPose}};
  EXPECT_DEATH(
      std::thread([&] { renderer.render(view, input); }).join(),
      testing::AllOf(HasSubstr("get_id() == owner_"), HasSubstr("frame_renderer.cpp:"),
                     HasSubstr("not the owner"), HasSubstr("[{\"marker\":40,"),
                     HasSubstr("amalgam-render --scene /scenes/broken.gltf --size 64x48 --poses "
                               "poses.json --renderer raytrace --max-depth 3\n")));
}

}  // namespace
}  // namespace amalgam::frame
