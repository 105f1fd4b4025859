#include "protocol/geometry.h"

#include <gtest/gtest.h>

namespace amalgam::protocol {
namespace {

TEST(Geometry, CamerasComeBack) {
  common::CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 600.5;
  camera.fy = 601.5;
  camera.cx = 319.25;
  camera.cy = 239.75;
  EXPECT_EQ(to_message(camera).distortion_size(), 0);
  EXPECT_EQ(from_message(to_message(camera)), camera);
  camera.distortion = {-0.1, 0.02, 0.001, -0.002, 0.003};
  EXPECT_EQ(from_message(to_message(camera)), camera);
  camera.distortion = {};
  camera.distortion.back() = 0.004;
  EXPECT_EQ(from_message(to_message(camera)), camera);
}

TEST(Geometry, PosesKeepTheirOrderOfComponents) {
  common::MarkerPose pose;
  pose.marker = 7;
  pose.rotation = glm::dquat(0.5, 0.1, 0.2, 0.3);  // w first
  pose.translation = {1, 2, 3};
  const Pose message = to_message(pose);
  EXPECT_EQ(message.rotation().w(), 0.5);
  EXPECT_EQ(message.rotation().x(), 0.1);
  const common::MarkerPose back = from_message(message);
  EXPECT_EQ(back.marker, 7);
  EXPECT_EQ(back.rotation, pose.rotation);
  EXPECT_EQ(back.translation, pose.translation);
}

TEST(Geometry, FisheyeLensesComeBack) {
  const common::FisheyeModel lens{1000, 900, 300, 301, 500, 450, 1.6};
  EXPECT_EQ(from_message(to_message(lens)), lens);
}

}  // namespace
}  // namespace amalgam::protocol
