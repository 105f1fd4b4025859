#include "passes/image/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "support/scene_builders.h"

namespace amalgam::passes {
namespace {

common::CameraModel distorting_camera() {
  common::CameraModel camera = test_support::make_pinhole(160, 120, 150.0);
  camera.distortion = {0.1, -0.2, 0.0075, 0.0034, 0.0};
  return camera;
}

// Layers that hold each pixel's own direction come out, at every camera pixel, with that pixel's.
TEST(Warp, PutsEveryDirectionWhereTheLensDoes) {
  const common::CameraModel camera = distorting_camera();
  const common::CameraModel ideal = common::ideal_camera_covering(camera);
  core::Layers layers({ideal.width, ideal.height});
  for (int y = 0; y < ideal.height; ++y) {
    for (int x = 0; x < ideal.width; ++x) {
      const glm::vec3 direction(*common::pixel_direction(ideal, {x, y}));
      layers.set(x, y, {glm::vec4(direction, 1.0f), direction});
    }
  }
  const WarpMap map = make_warp_map(camera, ideal);
  const core::Layers warped = warp_layers(layers, {.size = {160, 120}, .lens = &map});
  ASSERT_EQ(warped.size(), glm::ivec2(160, 120));
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const glm::vec3 expected(*common::pixel_direction(camera, {x, y}));
      ASSERT_NEAR(warped.at(x, y).difference.x, expected.x, 1e-5f) << x << " " << y;
      ASSERT_NEAR(warped.at(x, y).difference.y, expected.y, 1e-5f) << x << " " << y;
      ASSERT_NEAR(warped.at(x, y).over.w, 1.0f, 1e-5f)
          << "the margin covers the whole camera image";
    }
  }
}

TEST(Warp, EmptyLayersStayEmpty) {
  const common::CameraModel camera = distorting_camera();
  const common::CameraModel ideal = common::ideal_camera_covering(camera);
  const WarpMap map = make_warp_map(camera, ideal);
  const core::Layers warped =
      warp_layers(core::Layers({ideal.width, ideal.height}), {.size = {160, 120}, .lens = &map});
  EXPECT_TRUE(warped.present().empty());
}

// Each pixel's own direction once more, in fewer pixels: exact, since directions are linear in the
// place, up to the picture's edges.
TEST(Warp, ScalesWithAndWithoutALens) {
  for (const common::CameraModel& camera :
       {test_support::make_pinhole(160, 120, 150.0), distorting_camera()}) {
    const common::CameraModel ideal = common::ideal_camera_covering(camera);
    const WarpMap map = make_warp_map(camera, ideal);
    for (const double scale : {0.31, 0.5, 0.85}) {
      const common::CameraModel small = scaled_camera(ideal, scale);
      core::Layers layers({small.width, small.height});
      for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
          const glm::vec3 direction(*common::pixel_direction(small, {x, y}));
          layers.set(x, y, {glm::vec4(direction, 1.0f), direction});
        }
      }
      const core::Layers warped =
          warp_layers(layers, {.size = {160, 120},
                               .lens = camera.has_distortion() ? &map : nullptr,
                               .scale = static_cast<float>(scale)});
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          const glm::vec3 expected(*common::pixel_direction(camera, {x, y}));
          ASSERT_NEAR(warped.at(x, y).difference.x, expected.x, 1e-5f) << x << " " << y;
          ASSERT_NEAR(warped.at(x, y).difference.y, expected.y, 1e-5f) << x << " " << y;
          ASSERT_NEAR(warped.at(x, y).over.w, 1.0f, 1e-5f) << x << " " << y;
        }
      }
    }
  }
}

TEST(Warp, ScaleOfOneIsTheSameCamera) {
  const common::CameraModel camera = test_support::make_pinhole(161, 120, 150.0);
  EXPECT_EQ(scaled_camera(camera, 1.0), camera);
}

// Leaving out tiles changes nothing: one pixel alone, wherever it lies in its tile, is seen as if
// all tiles were there.
TEST(Warp, LeavesOutNoTileThatSomethingReachesInto) {
  for (const double scale : {0.5, 0.6, 0.85}) {
    const common::CameraModel small =
        scaled_camera(test_support::make_pinhole(160, 120, 150.0), scale);
    const LayerPlacement placement{.size = {160, 120}, .scale = static_cast<float>(scale)};
    for (int i = 1; i < small.height - 1; ++i) {
      core::Layers alone({small.width, small.height});
      alone.set(i, i, {glm::vec4(1.0f), glm::vec3(0.0f)});
      core::Layers all = alone;
      for (std::size_t tile = 0; tile < all.grid().count(); ++tile) all.make(tile);
      const common::ImageRgba32f expected = warp_layers(all, placement).over_image();
      const common::ImageRgba32f got = warp_layers(alone, placement).over_image();
      ASSERT_TRUE(std::ranges::equal(got.pixels(), expected.pixels())) << scale << " " << i;
    }
  }
}

// What only the margin shows is not in the picture, and an unaffected frame is not touched.
TEST(Warp, NothingLeftInThePictureIsNothing) {
  const common::CameraModel camera = distorting_camera();
  const common::CameraModel ideal = common::ideal_camera_covering(camera);
  const WarpMap map = make_warp_map(camera, ideal);
  const glm::vec2 corner = map.at.at(0, 0);
  ASSERT_GT(std::max(corner.x, corner.y), 1.0f) << "there is a margin";
  for (const bool in_picture : {false, true}) {
    core::Layers layers({ideal.width, ideal.height});
    const glm::ivec2 p = in_picture ? glm::ivec2(80, 60) : glm::ivec2(0, 0);
    layers.set(p.x, p.y, {glm::vec4(1.0f), glm::vec3(0.0f)});
    graph::FrameGraph graph;
    const auto warped = add_warp_pass(graph, graph.import("layers", std::move(layers)),
                                      {.size = {160, 120}, .lens = &map});
    EXPECT_EQ(graph.realise(warped) != nullptr, in_picture);
  }
}

}  // namespace
}  // namespace amalgam::passes
