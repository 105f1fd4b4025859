#include "passes/raster/real_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

// z where a pixel's ray meets the plane y = height, in the camera frame.
double plane_depth(const common::CameraModel& camera, const glm::dmat4& camera_from_world,
                   const glm::dvec2& pixel, double height) {
  const glm::dmat4 world_from_camera = common::rigid_inverse(camera_from_world);
  const glm::dvec3 eye(world_from_camera[3]);
  const glm::dvec3 direction(world_from_camera *
                             glm::dvec4(common::pixel_direction(camera, pixel).value(), 0.0));
  return (height - eye.y) / direction.y;  // direction has z = 1 in the camera frame
}

TEST(RealDepthPass, GivesTheExactDepthOfRealSurfacesOnly) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 2.0f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, make_quad({0.1f, 0.05f, 0}, {0.05f, 0, 0}, {0, 0, -0.05f}), make_mirror(),
             scene::Role::Real);
  add_object(scene, make_quad({-0.1f, 0.05f, 0}, {0.05f, 0, 0}, {0, 0, -0.05f}), make_mirror(),
             scene::Role::Virtual);
  const common::CameraModel camera = make_pinhole(160, 120, 150.0);
  const glm::dmat4 camera_from_world = look_at({0.0, 0.5, 0.5}, {0, 0, 0});
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(make_view(scene, camera, camera_from_world, {}, 2));
  ASSERT_TRUE(frame.real_depth);
  ASSERT_EQ(frame.real_depth->z.size(), glm::ivec2(160, 120));  // pixels, not samples
  int on_floor = 0, on_mirror = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const float z = frame.real_depth->z.at(x, y);
      const double floor = plane_depth(camera, camera_from_world, glm::dvec2(x, y), 0.0);
      const double mirror = plane_depth(camera, camera_from_world, glm::dvec2(x, y), 0.05);
      if (std::abs(z - floor) < 1e-5 * floor) ++on_floor;
      if (std::abs(z - mirror) < 1e-5 * mirror) ++on_mirror;
    }
  }
  EXPECT_EQ(on_floor + on_mirror, 160 * 120);
  EXPECT_GT(on_mirror, 100);
}

TEST(RealDepthPass, IsInfiniteWhereNothingIs) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.05f), make_mirror(), scene::Role::Real);
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(make_view(scene, make_pinhole(64, 64, 64.0),
                                                 look_at({0, 0.5, 0}, {0, 0, 0}, {0, 0, -1}), {}));
  EXPECT_TRUE(std::isinf(frame.real_depth->z.at(0, 0)));
  EXPECT_NEAR(frame.real_depth->z.at(32, 32), 0.5f, 1e-6f);
}

TEST(RealDepthPass, IsLeftOutWithoutRealObjects) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.5f), make_mirror(), scene::Role::Virtual);
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(make_view(scene, make_pinhole(64, 64, 64.0),
                                                 look_at({0, 0.5, 0}, {0, 0, 0}, {0, 0, -1}), {}));
  EXPECT_FALSE(frame.real_depth);
  EXPECT_TRUE(frame.report("mask").ran);
}

}  // namespace
}  // namespace amalgam::passes
