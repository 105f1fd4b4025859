// Each view may have light of its own: its frames are those of a renderer that has no other.
#include <gtest/gtest.h>

#include <optional>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"

namespace amalgam::frame {
namespace {

constexpr int kWidth = 96, kHeight = 72;

scene::Scene scene() {
  return scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf");
}

// Brighter on one side, so that lights have directions.
scene::Environment light(const glm::vec3& left, const glm::vec3& right) {
  scene::Environment environment{common::ImageRgb32f(32, 16), true};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) environment.radiance.at(x, y) = x < 16 ? left : right;
  }
  return environment;
}
const scene::Environment kRed = light({0.9f, 0.2f, 0.1f}, {0.2f, 0.1f, 0.1f});
const scene::Environment kBlue = light({0.1f, 0.1f, 0.2f}, {0.2f, 0.3f, 0.9f});
const scene::Environment kGreen = light({0.1f, 0.9f, 0.2f}, {0.1f, 0.8f, 0.2f});

class OwnEnvironment : public testing::TestWithParam<RendererMode> {
 protected:
  static ViewOptions options() {
    return {.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true};
  }
  RendererSettings settings() const {
    RendererSettings settings;
    settings.mode = GetParam();
    return settings;
  }
  FrameOutput render(FrameRenderer& renderer, ViewState& view) const {
    const common::ImageRgb8 grey(kWidth, kHeight, common::Rgb8(128));
    return renderer.render(view, {grey, {default_pose(renderer.scene().world.marker)}});
  }
  // The first frame of a view that never had another light; none: the scene's own.
  common::ImageRgb8 alone(FrameRenderer& renderer,
                          const std::optional<scene::Environment>& environment) const {
    if (environment) renderer.set_environment(*environment);
    ViewState view(options());
    return render(renderer, view).pixels;
  }
};

bool equal(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  return std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), b.pixels().end());
}

TEST_P(OwnEnvironment, LightsItsViewAndNoOther) {
  // One renderer after the other, because they share a thread's OpenGL context.
  std::optional<FrameRenderer> other;
  other.emplace(scene(), settings());
  const auto scene_alone = alone(*other, std::nullopt), red_alone = alone(*other, kRed),
             blue_alone = alone(*other, kBlue), green_alone = alone(*other, kGreen);
  other.reset();
  FrameRenderer renderer(scene(), settings());
  ViewState red(options()), blue(options()), plain(options());
  renderer.set_own_environment(red, kRed);
  renderer.set_own_environment(blue, kBlue);
  ASSERT_FALSE(equal(red_alone, blue_alone));
  // In turns, so that what is kept for one would be found by the next.
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(equal(render(renderer, red).pixels, red_alone)) << i;
    EXPECT_TRUE(equal(render(renderer, blue).pixels, blue_alone)) << i;
  }
  EXPECT_TRUE(equal(render(renderer, plain).pixels, scene_alone));

  renderer.set_environment(kGreen);
  ViewState later(options());
  EXPECT_TRUE(equal(render(renderer, later).pixels, green_alone));
  EXPECT_TRUE(equal(render(renderer, red).pixels, red_alone)) << "it keeps its own";
  EXPECT_EQ(blue.own_surroundings.use_count(), 1) << "nobody else keeps it when its view ends";
}

TEST_P(OwnEnvironment, MakesTheNextFrameAnew) {
  FrameRenderer renderer(scene(), settings());
  ViewState view(options());
  const auto reused = [&] { return render(renderer, view).statistics.rays.reused > 0; };
  for (int i = 0; i < 2; ++i) reused();
  ASSERT_TRUE(reused());
  renderer.set_own_environment(view, kRed);
  EXPECT_FALSE(reused());
  reused();
  ASSERT_TRUE(reused());
  // Of no concern to this view.
  renderer.set_environment(kBlue);
  EXPECT_TRUE(reused());
  // Equal, but not known to be.
  renderer.set_own_environment(view, kRed);
  EXPECT_FALSE(reused());
}

INSTANTIATE_TEST_SUITE_P(Modes, OwnEnvironment,
                         testing::Values(RendererMode::Hybrid, RendererMode::Raytrace));

}  // namespace
}  // namespace amalgam::frame
