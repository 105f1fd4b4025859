#include "passes/warp.h"

#include <gtest/gtest.h>

#include "support/scene_builders.h"

namespace amalgam::passes {
namespace {

core::CameraModel distorting_camera() {
  core::CameraModel camera = test_support::make_pinhole(160, 120, 150.0);
  camera.distortion = {0.1, -0.2, 0.0075, 0.0034, 0.0};
  return camera;
}

// Layers that hold each pixel's own direction come out, at every camera pixel, with that pixel's.
TEST(Warp, PutsEveryDirectionWhereTheLensDoes) {
  const core::CameraModel camera = distorting_camera();
  const core::CameraModel ideal = core::ideal_camera_covering(camera);
  core::Layers layers({ideal.width, ideal.height});
  for (int y = 0; y < ideal.height; ++y) {
    for (int x = 0; x < ideal.width; ++x) {
      const glm::vec3 direction(*core::pixel_direction(ideal, {x, y}));
      layers.set(x, y, glm::vec4(direction, 1.0f), direction);
    }
  }
  const core::Layers warped = warp_layers(layers, {.size = {160, 120}, .lens = &map});
  ASSERT_EQ(warped.size(), glm::ivec2(160, 120));
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const glm::vec3 expected(*core::pixel_direction(camera, {x, y}));
      ASSERT_NEAR(warped.difference(x, y).x, expected.x, 1e-5f) << x << " " << y;
      ASSERT_NEAR(warped.difference(x, y).y, expected.y, 1e-5f) << x << " " << y;
      ASSERT_NEAR(warped.over(x, y).w, 1.0f, 1e-5f) << "the margin covers the whole camera image";
    }
  }
}

TEST(Warp, EmptyLayersStayEmpty) {
  const core::CameraModel camera = distorting_camera();
  const core::CameraModel ideal = core::ideal_camera_covering(camera);
  const core::Layers warped =
      warp_layers(core::Layers({ideal.width, ideal.height}), make_warp_map(camera, ideal));
  EXPECT_TRUE(warped.present().empty());
}

}  // namespace
}  // namespace amalgam::passes
