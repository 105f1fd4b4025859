#include "common/fisheye_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace amalgam::common {
namespace {

constexpr double kPi = std::numbers::pi;

FisheyeModel lens(double max_angle = kPi) {
  return {.width = 1000,
          .height = 900,
          .fx = 300.0,
          .fy = 290.0,
          .cx = 499.5,
          .cy = 451.0,
          .max_angle = max_angle};
}

TEST(FisheyeModel, DistanceFromTheCentreIsTheAngle) {
  const FisheyeModel fisheye = lens();
  EXPECT_EQ(project(fisheye, {0, 0, 2}), glm::dvec2(499.5, 451.0));
  const auto right = project(fisheye, {1, 0, 0}).value();  // 90 degrees
  EXPECT_NEAR(right.x, 499.5 + 300.0 * kPi / 2, 1e-9);
  EXPECT_NEAR(right.y, 451.0, 1e-9);
  const auto down = project(fisheye, {0, 1, 1}).value();  // 45 degrees; y points down
  EXPECT_NEAR(down.y, 451.0 + 290.0 * kPi / 4, 1e-9);
  const auto behind = project(fisheye, {0, -1e-3, -1}).value();  // nearly 180 degrees
  EXPECT_NEAR(behind.y, 451.0 - 290.0 * (kPi - 1e-3), 1e-6);
  EXPECT_TRUE(project(fisheye, {0, 0, -1}));
}

TEST(FisheyeModel, ProjectAndPixelDirectionAreInverse) {
  const FisheyeModel fisheye = lens();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10000; ++i) {
    const auto direction =
        glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const auto pixel = project(fisheye, direction);
    ASSERT_TRUE(pixel);
    const auto back = pixel_direction(fisheye, *pixel);
    ASSERT_TRUE(back);
    EXPECT_LT(glm::distance(*back, direction), 1e-12);
    EXPECT_NEAR(glm::length(*back), 1.0, 1e-14);
  }
}

TEST(FisheyeModel, NothingIsSeenBeyondTheLargestAngle) {
  const FisheyeModel fisheye = lens(1.2);
  const auto at = [](double angle) { return glm::dvec3(std::sin(angle), 0, std::cos(angle)); };
  EXPECT_TRUE(project(fisheye, at(1.2)));
  EXPECT_FALSE(project(fisheye, at(1.21)));
  EXPECT_FALSE(project(fisheye, {0, 0, -1}));
  EXPECT_TRUE(pixel_direction(fisheye, {499.5 + 300.0 * 1.19, 451.0}));
  EXPECT_FALSE(pixel_direction(fisheye, {499.5 + 300.0 * 1.21, 451.0}));
  // Corners of the image may lie beyond pi: that is no direction at all.
  EXPECT_FALSE(pixel_direction(lens(), {499.5 + 300.0 * 3.2, 451.0}));
}

TEST(FisheyeModel, WhatIsNoDirectionHasNoPixel) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(project(lens(), {0, 0, 0}));
  EXPECT_FALSE(project(lens(), {nan, 0, 1}));
  EXPECT_FALSE(project(lens(), {0, 0, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(pixel_direction(lens(), {nan, 0}));
}

TEST(FisheyeModel, DefectsAreDescribed) {
  const auto defect = [](auto change) {
    FisheyeModel fisheye = lens();
    change(fisheye);
    return describe_defect(fisheye);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(describe_defect(lens()), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.width = 0; }), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.height = 8193; }), "");
  EXPECT_NE(defect([&](FisheyeModel& f) { f.fx = nan; }), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.fy = 0.5; }), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.cx = 1e6; }), "");
  EXPECT_NE(defect([&](FisheyeModel& f) { f.cy = nan; }), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.max_angle = 0.0; }), "");
  EXPECT_NE(defect([](FisheyeModel& f) { f.max_angle = 3.2; }), "");
  EXPECT_NE(defect([&](FisheyeModel& f) { f.max_angle = nan; }), "");
}

}  // namespace
}  // namespace amalgam::common
