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
  const WarpMap map = make_warp_map(camera, ideal);
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
  const WarpMap map = make_warp_map(camera, ideal);
  const core::Layers warped =
      warp_layers(core::Layers({ideal.width, ideal.height}), {.size = {160, 120}, .lens = &map});
  EXPECT_TRUE(warped.present().empty());
}

// Each pixel's own direction once more, in fewer pixels: exact, since directions are linear in the
// place, up to the picture's edges.
TEST(Warp, ScalesWithAndWithoutALens) {
  for (const core::CameraModel& camera :
       {test_support::make_pinhole(160, 120, 150.0), distorting_camera()}) {
    const core::CameraModel ideal = core::ideal_camera_covering(camera);
    const WarpMap map = make_warp_map(camera, ideal);
    for (const double scale : {0.31, 0.5, 0.85}) {
      const core::CameraModel small = scaled_camera(ideal, scale);
      core::Layers layers({small.width, small.height});
      for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
          const glm::vec3 direction(*core::pixel_direction(small, {x, y}));
          layers.set(x, y, glm::vec4(direction, 1.0f), direction);
        }
      }
      const core::Layers warped =
          warp_layers(layers, {.size = {160, 120},
                               .lens = camera.has_distortion() ? &map : nullptr,
                               .scale = static_cast<float>(scale)});
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          const glm::vec3 expected(*core::pixel_direction(camera, {x, y}));
          ASSERT_NEAR(warped.difference(x, y).x, expected.x, 1e-5f) << x << " " << y;
          ASSERT_NEAR(warped.difference(x, y).y, expected.y, 1e-5f) << x << " " << y;
          ASSERT_NEAR(warped.over(x, y).w, 1.0f, 1e-5f) << x << " " << y;
        }
      }
    }
  }
}

TEST(Warp, ScaleOfOneIsTheSameCamera) {
  const core::CameraModel camera = test_support::make_pinhole(161, 120, 150.0);
  EXPECT_EQ(scaled_camera(camera, 1.0), camera);
}

// One pixel alone, wherever it lies in its tile, is seen by all that it is mixed into.
TEST(Warp, LeavesOutNoTileThatSomethingReachesInto) {
  constexpr float kScale = 0.5f;
  const core::CameraModel small = scaled_camera(test_support::make_pinhole(160, 120, 150.0), 0.5);
  for (const glm::ivec2& p : {glm::ivec2(1, 1), glm::ivec2(15, 15), glm::ivec2(16, 16),
                              glm::ivec2(31, 32), glm::ivec2(80, 60)}) {
    core::Layers layers({small.width, small.height});
    layers.set(p.x, p.y, glm::vec4(1.0f), glm::vec3(0.0f));
    const core::Layers warped = warp_layers(layers, {.size = {160, 120}, .scale = kScale});
    float sum = 0.0f;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) sum += warped.over(x, y).w;
    }
    // Its area, 2 x 2; less at the corner, where part of it lies outside.
    const bool corner = p.x == 1 || p.x == 80;
    if (corner) {
      EXPECT_GT(sum, 2.0f);
    } else {
      EXPECT_NEAR(sum, 4.0f, 1e-4f) << p.x;
    }
  }
}

}  // namespace
}  // namespace amalgam::passes
