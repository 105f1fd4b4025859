#include "client/tracking/pose_dead_band.h"

#include <gtest/gtest.h>

namespace amalgam::client {
namespace {

constexpr double kLength = 0.05, kDistance = 0.5;  // metres

common::MarkerPose pose_at(double x, int marker = 40) {
  common::MarkerPose pose;
  pose.marker = marker;
  pose.translation = {x, 0.0, kDistance};
  return pose;
}

// Metres by which a marker that faces the camera moves one pixel: on the marker. A point one length
// above it, and so farther from the camera here, moves less.
double one_pixel(const common::CameraModel& camera) {
  return kDistance / camera.fx;
}

class DeadBand : public testing::Test {
 protected:
  common::CameraModel camera_ = common::default_camera(640, 480);
  PoseDeadBand band_{0.5, kLength, camera_};

  double held_x(double x) { return band_.hold({pose_at(x)}).at(0).translation.x; }
};

TEST_F(DeadBand, SmallerMovesSendTheLastPoseAgain) {
  const double pixel = one_pixel(camera_);
  EXPECT_EQ(held_x(0.0), 0.0);
  EXPECT_EQ(held_x(0.45 * pixel), 0.0);
  EXPECT_EQ(held_x(-0.45 * pixel), 0.0);
  EXPECT_EQ(held_x(0.55 * pixel), 0.55 * pixel);
  EXPECT_EQ(band_.held(), 2u);
}

// Compared with the pose that was sent, not with the one before: slow motion is followed.
TEST_F(DeadBand, SlowMotionIsFollowed) {
  const double pixel = one_pixel(camera_);
  for (int i = 0; i <= 1000; ++i) {
    const double x = 0.01 * i * pixel;
    EXPECT_LE(std::abs(held_x(x) - x), 0.5001 * pixel) << i;
  }
}

// Turning about the marker's middle moves its corners, and what stands on it more.
TEST_F(DeadBand, TurningCounts) {
  band_.hold({pose_at(0.0)});
  common::MarkerPose turned = pose_at(0.0);
  turned.rotation = glm::angleAxis(0.05, glm::dvec3(0, 1, 0));
  EXPECT_EQ(band_.hold({turned}).at(0).rotation, turned.rotation);
  turned.rotation = glm::angleAxis(0.0505, glm::dvec3(0, 1, 0));
  EXPECT_NE(band_.hold({turned}).at(0).rotation, turned.rotation);
}

TEST_F(DeadBand, EachMarkerHasItsOwn) {
  const double pixel = one_pixel(camera_);
  band_.hold({pose_at(0.0, 1), pose_at(0.1, 2)});
  const auto poses = band_.hold({pose_at(0.2 * pixel, 1), pose_at(0.1 + 3 * pixel, 2)});
  EXPECT_EQ(poses.at(0).translation.x, 0.0);
  EXPECT_EQ(poses.at(1).translation.x, 0.1 + 3 * pixel);
}

TEST_F(DeadBand, AMarkerThatWasAwayBeginsAnew) {
  const double x = 0.1 * one_pixel(camera_);
  held_x(0.0);
  band_.hold({});
  EXPECT_EQ(held_x(x), x);
}

TEST_F(DeadBand, WhatCannotBeProjectedIsPassedOn) {
  common::MarkerPose behind = pose_at(0.0);
  behind.translation.z = -1.0;
  common::MarkerPose other = behind;
  other.translation.x = 1e-9;
  band_.hold({behind});
  EXPECT_EQ(band_.hold({other}).at(0).translation, other.translation);
}

}  // namespace
}  // namespace amalgam::client
