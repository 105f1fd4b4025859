// numerics B14 and B15: rays through pixels against the exact direction, for all lenses that are
// accepted; and points that come ever nearer to the camera's plane.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "common/camera_model.h"
#include "support/scene_builders.h"

namespace amalgam::common {
namespace {

using Exact = long double;

// Radians between a direction and the exact one through the pixel.
double angle_off(const CameraModel& camera, const glm::dvec2& pixel) {
  const Exact x =
      (static_cast<Exact>(pixel.x) - static_cast<Exact>(camera.cx)) / static_cast<Exact>(camera.fx);
  const Exact y =
      (static_cast<Exact>(pixel.y) - static_cast<Exact>(camera.cy)) / static_cast<Exact>(camera.fy);
  const auto d = pixel_direction(camera, pixel).value();
  const Exact cx = y * static_cast<Exact>(d.z) - static_cast<Exact>(d.y);
  const Exact cy = static_cast<Exact>(d.x) - x * static_cast<Exact>(d.z);
  const Exact cz = x * static_cast<Exact>(d.y) - y * static_cast<Exact>(d.x);
  const Exact cross = std::sqrt(cx * cx + cy * cy + cz * cz);
  return static_cast<double>(std::atan2(
      cross, x * static_cast<Exact>(d.x) + y * static_cast<Exact>(d.y) + static_cast<Exact>(d.z)));
}

TEST(Lens, RaysAreExactForEveryFocalLength) {
  for (double focal = 1.0; focal < 1.5e6; focal *= 10.0) {
    CameraModel camera = test_support::make_pinhole(8192, 8192, focal);
    camera.cx += 0.37;
    ASSERT_EQ(describe_defect(camera), "") << focal;
    for (const double x : {-0.5, 17.3, 4095.9, 8191.5}) {
      for (const double y : {-0.5, 4096.1, 8191.5}) {
        EXPECT_LT(angle_off(camera, {x, y}), 1e-15) << focal << " " << x << " " << y;
        const auto back = project(camera, pixel_direction(camera, {x, y}).value());
        ASSERT_TRUE(back) << focal;
        EXPECT_LT(glm::distance(*back, {x, y}), 1e-6) << focal << " " << x << " " << y;
      }
    }
  }
  // Beyond: refused.
  for (const double focal : {0.9, 1.1e6}) {
    EXPECT_NE(describe_defect(test_support::make_pinhole(8192, 8192, focal)), "") << focal;
  }
}

TEST(Lens, PointsAreProjectedDownToANanometreBeforeTheCamera) {
  const CameraModel camera = test_support::make_pinhole(640, 480, 500.0);
  for (const double z : {1.0, 1e-3, 1e-6, 1e-8, 1.1e-9}) {
    const auto pixel = project(camera, {0.3 * z, -0.2 * z, z});
    ASSERT_TRUE(pixel) << z;
    EXPECT_NEAR(pixel->x, camera.cx + 150.0, 1e-9) << z;
    EXPECT_NEAR(pixel->y, camera.cy - 100.0, 1e-9) << z;
    EXPECT_FALSE(project(camera, {0.3 * z, -0.2 * z, -z})) << z;
  }
  // Beyond: no pixel, not one at infinity.
  for (const double z : {1e-9, 1e-12, 1e-300, 0.0}) EXPECT_FALSE(project(camera, {z, z, z})) << z;
}

}  // namespace
}  // namespace amalgam::common
