// Cameras at places and with lenses that nobody would choose.
#include <gtest/gtest.h>

#include <numbers>

#include "extreme/desk.h"
#include "support/scene_builders.h"

namespace amalgam::extreme {
namespace {

using test_support::make_pinhole;

common::CameraModel camera_of_width(double degrees) {
  return make_pinhole(kDeskWidth, kDeskHeight,
                      0.5 * kDeskWidth / std::tan(degrees * std::numbers::pi / 360.0));
}

TEST(ExtremeCamera, InsideGlass) {
  parity::ParityCase desk = make_desk();
  const glm::dvec3 beside_the_bubble(0.5 * (kGlassRadius + kBubbleRadius), 0.0, 0.0);
  place_camera(desk, 1.0, kGlassMiddle + beside_the_bubble, {0.0, 0.05, -0.1});
  desk.name = "inside glass";
  expect_right(desk);
}

TEST(ExtremeCamera, InsideABubbleInGlass) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, kGlassMiddle, {0.0, 0.05, -0.1});
  desk.name = "inside a bubble";
  expect_right(desk);
}

// A thousandth of a millimetre above it.
TEST(ExtremeCamera, OnTheFloor) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, {0.0, 1e-6, 0.9}, {0.0, 1e-6, -0.1});
  desk.name = "on the floor";
  expect_right(desk);
}

// Exactly in the floor, rays begin on it, and whether they meet it is decided by rounding.
TEST(ExtremeCamera, InTheFloorIsFinite) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, {0.0, 0.0, 0.9}, {0.0, 0.0, -0.1});
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    EXPECT_EQ(render(desk, mode).statistics.nonfinite, 0u);
  }
}

// Inside or outside is undecided there: the picture need only be finite.
TEST(ExtremeCamera, OnTheSurfaceOfGlass) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, kGlassMiddle + glm::dvec3(0.0, kGlassRadius, 0.0), {0.1, 0.1, -0.3});
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    const parity::Rendering picture = render(desk, mode);
    EXPECT_EQ(picture.statistics.nonfinite, 0u);
    EXPECT_GT(picture.statistics.pixels.virtual_pixels, 0u);
  }
}

TEST(ExtremeCamera, WithItsBackToEverythingChangesNothing) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, {0.0, 0.5, 2.0}, {0.0, 0.6, 4.0});
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    EXPECT_TRUE(render(desk, mode).composite == desk.camera_image);
  }
}

TEST(ExtremeCamera, OneDegreeWide) {
  parity::ParityCase desk = make_desk();
  set_camera(desk, camera_of_width(1.0));
  place_camera(desk, 1.0, {0.11, 0.55, 0.8}, {0.2, 0.2, 0.1});
  desk.name = "one degree";
  expect_right(desk);
}

TEST(ExtremeCamera, A170DegreesWide) {
  parity::ParityCase desk = make_desk();
  set_camera(desk, camera_of_width(170.0));
  place_camera(desk, 1.0, {0.0, 0.25, 0.12}, {0.0, 0.15, 0.0});
  desk.name = "170 degrees";
  expect_right(desk);
}

TEST(ExtremeCamera, AxisOutsideTheImage) {
  parity::ParityCase desk = make_desk();
  common::CameraModel camera = make_pinhole(kDeskWidth, kDeskHeight, kDeskWidth);
  camera.cx = -1.0 * kDeskWidth;
  set_camera(desk, camera);
  // The axis points as far to the left of the desk as it lies beside the image.
  const glm::dvec3 eye(0.11, 0.55, 0.8), to_desk = glm::dvec3(0.0, 0.1, 0.0) - eye;
  const glm::dvec3 left = glm::cross(glm::dvec3(0.0, 1.0, 0.0), to_desk);
  place_camera(desk, 1.0, eye, eye + to_desk + 1.5 * left);
  desk.name = "axis outside";
  expect_right(desk);
}

TEST(ExtremeCamera, OnePixel) {
  parity::ParityCase desk = make_desk();
  set_camera(desk, make_pinhole(1, 1, 2.0));
  place_camera(desk, 1.0, {0.11, 0.55, 0.8}, {0.15, 0.13, 0.05});
  desk.name = "one pixel";
  expect_right(desk);
}

TEST(ExtremeCamera, AStripOf4096By16) {
  parity::ParityCase desk = make_desk();
  set_camera(desk, make_pinhole(4096, 16, 4096.0));
  desk.name = "strip";
  expect_both_alike(desk);
}

TEST(ExtremeCamera, TooLargeIsRefused) {
  for (const glm::ivec2& size : {glm::ivec2(8193, 16), {16, 8193}, {0, 16}, {16, -1}}) {
    frame::ViewOptions options;
    options.camera = make_pinhole(size.x, size.y, 100.0);
    EXPECT_THROW(frame::ViewState{options}, std::invalid_argument) << size.x << " x " << size.y;
  }
}

// A twentieth of a degree above the floor.
TEST(ExtremeCamera, Grazing) {
  parity::ParityCase desk = make_desk();
  place_camera(desk, 1.0, {0.0, 0.00085, 0.95}, {0.0, 0.0, 0.0});
  desk.name = "grazing";
  expect_right(desk);
}

TEST(ExtremeCamera, OneMillimetreAndOneKilometreAway) {
  for (const double size : {1e-3, 1000.0}) {
    parity::ParityCase desk = make_desk(size);
    expect_right(desk);
  }
}

// Poses further away than ten thousand kilometres are not believed.
TEST(ExtremeCamera, BeyondTenThousandKilometresChangesNothing) {
  parity::ParityCase desk = make_desk(1000.0);
  place_camera(desk, 1e7, {0.0, 0.3, 1.1}, {0.0, 0.3, 0.0});
  ASSERT_FALSE(common::is_usable(desk.poses[0]));
  EXPECT_TRUE(render(desk, frame::RendererMode::Raytrace).composite == desk.camera_image);
}

}  // namespace
}  // namespace amalgam::extreme
