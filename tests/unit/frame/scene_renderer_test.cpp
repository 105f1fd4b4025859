// What a server's renderer has done before its first client comes.
#include "frame/scene_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "codec/jpeg.h"
#include "core/timings.h"
#include "frame/default_view.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

constexpr int kMarker = 40, kWidth = 320, kHeight = 240;

scene::Scene glass_ball_on_table() {
  scene::Scene scene;
  scene.world.marker = kMarker;
  scene.environment = scene::Environment{common::ImageRgb32f(16, 8, glm::vec3(1.0f)), false};
  test_support::add_object(scene, test_support::make_floor(0.0f, 0.5f),
                           test_support::make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  test_support::add_object(scene, test_support::make_sphere({0.0f, 0.03f, 0.0f}, 0.03f),
                           test_support::make_glass(), scene::Role::Virtual);
  return scene;
}

// Frames that nobody asked a composite of cost nothing, and then neither the shaders were compiled
// before the first client came, nor was it known whether there is time for a second one.
TEST(SceneRenderer, KnowsWhatAFrameCostsBeforeTheFirstClient) {
  const auto renderer = renderer_of_scene(glass_ball_on_table(), {})();
  const auto view = renderer->open({.camera = common::default_camera(kWidth, kHeight)});
  const Bytes jpeg = codec::encode_jpeg({kWidth, kHeight, common::Rgb8(128)}, 90);
  double least = 1e9, most = 0.0;
  for (int frame = 0; frame < 3; ++frame) {
    common::MarkerPose pose = default_pose(kMarker);
    pose.translation.x += 1e-3 * frame;  // otherwise what was drawn is kept
    const core::Stopwatch stopwatch;
    renderer->render(*view, {jpeg, {pose}});
    const double seconds = stopwatch.milliseconds() / 1000.0;
    least = std::min(least, seconds);
    most = std::max(most, seconds);
  }
  // Ten times either way is for a machine with much else to do.
  const double estimate = renderer->seconds_per_pixel() * kWidth * kHeight;
  EXPECT_GT(estimate, 0.1 * least);
  EXPECT_LT(estimate, 10.0 * most);
}

}  // namespace
}  // namespace amalgam::frame
