// What a failed check prints is taken by a shell and by amalgam-render.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "frame/replay_text.h"
#include "scene/gltf/loader.h"

namespace amalgam::tests {
namespace {

namespace fs = std::filesystem;

TEST(Replay, TheTextMakesTheFrameAgain) {
  const scene::Scene scene = scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/complex.gltf");
  common::CameraModel camera = common::default_camera(160, 120);
  camera.fx *= 1.1;
  camera.distortion = {0.1, -0.2, 0.0075, 1e-5, 0.0};
  common::MarkerPose pose = frame::default_pose(scene.world.marker);
  pose.translation.x += 1.0 / 30.0;
  const frame::FrameInput input{common::ImageRgb8(160, 120, common::Rgb8(128)), {pose}};
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  settings.trace.max_depth = 3;
  settings.exposure = 0.7f;

  frame::FrameRenderer renderer(scene, settings);
  frame::ViewState view({.camera = camera, .keep_pixels = true});
  const core::RayCounts rays = renderer.render(view, input).statistics.rays;

  const std::string text = frame::replay_text({.scene_path = scene.path,
                                               .camera = camera,
                                               .poses = input.poses,
                                               .settings = settings,
                                               .keep_provenance = true});
  const fs::path folder =
      fs::temp_directory_path() / ("amalgam-replay-test-" + std::to_string(getpid()));
  fs::create_directories(folder);
  // The comments end with their lines, and the output is that of all that stands in braces.
  const std::string command = "cd '" + folder.string() +
                              "' && PATH='" AMALGAM_BINARY_DIR "/bin':$PATH && {\n" + text +
                              "\n} > replay.json";
  ASSERT_EQ(std::system(command.c_str()), 0) << text;
  const nlohmann::json replay = nlohmann::json::parse(std::ifstream(folder / "replay.json"));
  EXPECT_EQ(replay.at("rays").at("primary"), rays.primary) << replay.dump(2);
  EXPECT_EQ(replay.at("rays").at("refraction"), rays.refraction);
  EXPECT_EQ(replay.at("rays").at("reflection"), rays.reflection);
  EXPECT_GT(rays.refraction, 0u);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace amalgam::tests
