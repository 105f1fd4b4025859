// Shading by tile changes nothing: whole frames of our scenes, with and without it.
#include <gtest/gtest.h>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"
#include "support/compare_images.h"

namespace amalgam::frame {
namespace {

class LeaveOutTiles : public testing::TestWithParam<const char*> {};

FrameOutput render(const std::string& scene, bool leave_out, RendererMode mode,
                   std::optional<float> exposure) {
  RendererSettings settings;
  settings.mode = mode;
  settings.leave_out_tiles = leave_out;
  settings.exposure = exposure;
  settings.samples_per_pixel = mode == RendererMode::Hybrid ? 1 : 4;
  settings.trace.max_depth = 2;
  FrameRenderer renderer(scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/" + scene + ".gltf"),
                         settings);
  ViewState view({.camera = common::default_camera(200, 150), .keep_pixels = true});
  const common::ImageRgb8 grey(200, 150, common::Rgb8(120, 130, 110));
  return renderer.render(view, {grey, {default_pose(renderer.scene().world.marker)}});
}

TEST_P(LeaveOutTiles, GivesTheSamePicture) {
  for (const RendererMode mode : {RendererMode::Hybrid, RendererMode::Diffuse}) {
    for (const std::optional<float> exposure : {std::optional<float>(), std::optional(0.7f)}) {
      const FrameOutput by_tile = render(GetParam(), true, mode, exposure);
      const FrameOutput whole = render(GetParam(), false, mode, exposure);
      const std::string name = mode == RendererMode::Hybrid ? "hybrid" : "diffuse";
      EXPECT_TRUE(test_support::images_are_same(name + (exposure ? "-fixed-exposure" : "-metered"),
                                                by_tile.pixels, whole.pixels));
      EXPECT_EQ(by_tile.unchanged, whole.unchanged);
      EXPECT_EQ(by_tile.statistics.exposure, whole.statistics.exposure);
      EXPECT_EQ(by_tile.statistics.nonfinite, whole.statistics.nonfinite);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, LeaveOutTiles,
                         testing::Values("complex", "diffuse", "mirror", "glassware", "markers"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace amalgam::frame
