#include "common/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace amalgam::common {
namespace {

CameraModel pinhole() {
  CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 628.158;
  camera.fy = 628.156;
  camera.cx = 324.099;
  camera.cy = 260.908;
  return camera;
}

// The calibration that comes with OpenCV's photograph of markers.
CameraModel photograph_camera() {
  CameraModel camera = pinhole();
  camera.distortion = {0.0995485, -0.206384, 0.00754589, 0.00336531};
  return camera;
}

CameraModel all_coefficients() {
  CameraModel camera = pinhole();
  camera.distortion = {0.2,   -0.1, 0.003, -0.002, 0.05,  0.15,
                       -0.05, 0.02, 0.002, -0.001, 0.001, 0.002};
  return camera;
}

// The outer edges of the outermost pixels are half the angle from the axis.
TEST(CameraModel, ACameraOfAViewIsThatWide) {
  const CameraModel camera = camera_of_view(640, 480, 90.0);
  EXPECT_NEAR(camera.fx, 320.0, 1e-9);
  EXPECT_EQ(camera.fy, camera.fx);
  EXPECT_EQ(camera.cx, 319.5);
  EXPECT_EQ(camera.cy, 239.5);
  EXPECT_EQ(default_camera(640, 480), camera_of_view(640, 480, 60.0));
}

TEST(CameraModel, DistortionMatchesTheWrittenOutModel) {
  const CameraModel camera = photograph_camera();
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const auto [k1, k2, p1, p2] = std::array{0.0995485, -0.206384, 0.00754589, 0.00336531};
  const double radial = 1 + k1 * r2 + k2 * r2 * r2;
  const glm::dvec2 d = distort(camera, {x, y});
  EXPECT_NEAR(d.x, x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), 1e-15);
  EXPECT_NEAR(d.y, y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y, 1e-15);
}

TEST(CameraModel, DistortAndUndistortAreInverse) {
  for (const CameraModel& camera : {pinhole(), photograph_camera(), all_coefficients()}) {
    ASSERT_EQ(describe_defect(camera), "");
    for (int y = 0; y < camera.height; y += 7) {
      for (int x = 0; x < camera.width; x += 7) {
        const glm::dvec2 distorted((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy);
        const auto ideal = undistort(camera, distorted);
        ASSERT_TRUE(ideal) << x << " " << y;
        EXPECT_LT(glm::length(distort(camera, *ideal) - distorted), 1e-9) << x << " " << y;
      }
    }
  }
}

// numerics B14: the direction of a pixel and the pixel of a direction belong together.
TEST(CameraModel, ProjectAndPixelDirectionAreInverse) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  for (const CameraModel& camera : {pinhole(), photograph_camera(), all_coefficients()}) {
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec2 pixel(u(random) * camera.width - 0.5, u(random) * camera.height - 0.5);
      const auto direction = pixel_direction(camera, pixel);
      ASSERT_TRUE(direction);
      EXPECT_EQ(direction->z, 1.0);
      const auto back = project(camera, *direction * (0.01 + 100.0 * u(random)));
      ASSERT_TRUE(back);
      EXPECT_LT(glm::length(*back - pixel), 1e-6);
    }
  }
}

// numerics A1 and B15: dividing by a w of 0 or less would put such points into the image.
TEST(CameraModel, PointsBehindBesideAndAtTheCameraHaveNoPixel) {
  for (const CameraModel& camera : {pinhole(), photograph_camera()}) {
    EXPECT_FALSE(project(camera, {0, 0, -1}));
    EXPECT_FALSE(project(camera, {0.1, 0.1, -1e-12}));
    EXPECT_FALSE(project(camera, {1, 0, 0}));
    EXPECT_FALSE(project(camera, {0, 0, 0}));
    EXPECT_FALSE(project(camera, {0, 0, std::numeric_limits<double>::quiet_NaN()}));
    EXPECT_TRUE(project(camera, {0, 0, 1e-6}));
  }
}

TEST(CameraModel, NothingIsSeenBeyondAFold) {
  CameraModel camera = pinhole();
  camera.distortion = {-0.3};  // r (1 - 0.3 r^2) turns back at r = 1.054
  EXPECT_TRUE(project(camera, {0.9, 0.0, 1.0}));
  EXPECT_FALSE(project(camera, {1.7, 0.0, 1.0}));
  EXPECT_FALSE(undistort(camera, {0.8, 0.0}));  // no radius is distorted to more than 0.703
}

// A tangential coefficient alone, along its own axis: x + 3 p x^2 turns back at x = -1 / (6 p).
TEST(CameraModel, TangentialDistortionFoldsWhereItTurnsBack) {
  CameraModel camera = pinhole();
  for (const int axis : {0, 1}) {
    camera.distortion = {};
    camera.distortion[axis == 0 ? 3 : 2] = -0.3;
    glm::dvec3 before(0.0, 0.0, 1.0), beyond(0.0, 0.0, 1.0);
    before[axis] = 0.54;
    beyond[axis] = 0.57;
    EXPECT_TRUE(project(camera, before));
    EXPECT_FALSE(project(camera, beyond));
  }
}

TEST(CameraModel, IdealCameraSeesEveryBorderPixel) {
  for (const CameraModel& camera : {photograph_camera(), all_coefficients()}) {
    const CameraModel ideal = ideal_camera_covering(camera);
    EXPECT_FALSE(ideal.has_distortion());
    EXPECT_GE(ideal.width, camera.width);
    EXPECT_GE(ideal.height, camera.height);
    const auto check = [&](double x, double y) {
      const auto direction = pixel_direction(camera, {x, y});
      ASSERT_TRUE(direction);
      const auto pixel = project(ideal, *direction);
      ASSERT_TRUE(pixel);
      EXPECT_GE(pixel->x, -0.5);
      EXPECT_GE(pixel->y, -0.5);
      EXPECT_LE(pixel->x, ideal.width - 0.5);
      EXPECT_LE(pixel->y, ideal.height - 0.5);
    };
    for (int x = 0; x < camera.width; ++x) {
      check(x, 0);
      check(x, camera.height - 1);
    }
    for (int y = 0; y < camera.height; ++y) {
      check(0, y);
      check(camera.width - 1, y);
    }
  }
}

// Of a barrel lens, whose principal point is not in the middle: a whole pixel more on each side
// than the border needs, and less than two.
TEST(CameraModel, IdealCameraHasTheMarginsThatEachSideNeeds) {
  CameraModel camera = pinhole();
  camera.distortion = {-0.2};
  const CameraModel ideal = ideal_camera_covering(camera);
  glm::dvec2 low(1e9), high(-1e9);
  const auto visit = [&](double x, double y) {
    const glm::dvec2 at = *project(ideal, *pixel_direction(camera, {x, y}));
    low = glm::min(low, at);
    high = glm::max(high, at);
  };
  for (double x = -0.5; x <= camera.width - 0.5; ++x) {
    visit(x, -0.5);
    visit(x, camera.height - 0.5);
  }
  for (double y = -0.5; y <= camera.height - 0.5; ++y) {
    visit(-0.5, y);
    visit(camera.width - 0.5, y);
  }
  const glm::dvec2 last(ideal.width - 0.5, ideal.height - 0.5);
  for (const glm::dvec2& margin : {low + 0.5, last - high}) {
    for (const int axis : {0, 1}) {
      EXPECT_GT(margin[axis], 0.9);  // corners lie farthest out, and are among the points asked for
      EXPECT_LT(margin[axis], 2.1);
    }
  }
}

TEST(CameraModel, WithoutDistortionTheIdealCameraIsTheCamera) {
  EXPECT_EQ(ideal_camera_covering(pinhole()), pinhole());
}

// 60 degrees wide, and pixel (x, y) has its centre at (x, y).
TEST(CameraModel, TheDefaultCameraLooksAtTheMiddleOfItsImage) {
  const CameraModel camera = default_camera(640, 480);
  EXPECT_EQ(glm::dvec2(camera.cx, camera.cy), glm::dvec2(319.5, 239.5));
  const glm::dvec3 left = *pixel_direction(camera, {-0.5, 239.5});
  EXPECT_NEAR(left.x, -1.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(left.y, 0.0, 1e-12);
}

TEST(CameraModel, DefectsAreDescribed) {
  const auto defect = [](auto change) {
    CameraModel camera = pinhole();
    change(camera);
    return describe_defect(camera);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(describe_defect(pinhole()), "");
  EXPECT_NE(defect([](CameraModel& c) { c.width = 0; }), "");
  EXPECT_NE(defect([](CameraModel& c) { c.height = 8193; }), "");
  EXPECT_NE(defect([&](CameraModel& c) { c.fx = nan; }), "");
  EXPECT_NE(defect([](CameraModel& c) { c.fy = 0; }), "");
  EXPECT_NE(defect([&](CameraModel& c) { c.cx = nan; }), "");
  EXPECT_NE(defect([](CameraModel& c) { c.cy = 1e9; }), "");
  EXPECT_NE(defect([&](CameraModel& c) { c.distortion[3] = nan; }), "");
  EXPECT_NE(defect([](CameraModel& c) { c.distortion[0] = -2.0; }), "");  // folds inside the image
}

}  // namespace
}  // namespace amalgam::common
