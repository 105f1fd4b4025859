#include "common/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

namespace amalgam::common {
namespace {

MarkerPose some_pose() {
  MarkerPose pose;
  pose.marker = 40;
  pose.rotation = glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.2));
  pose.translation = {0.1, -0.2, 0.7};
  return pose;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  }
  return largest;
}

TEST(Pose, RigidInverseIsTheInverse) {
  const glm::dmat4 pose = to_matrix(some_pose());
  EXPECT_LT(largest_difference(rigid_inverse(pose) * pose, glm::dmat4(1.0)), 1e-15);
  EXPECT_LT(largest_difference(rigid_inverse(pose), glm::inverse(pose)), 1e-14);
}

TEST(Pose, GltfStandsUprightOnTheMarker) {
  const glm::dmat4 m = opencv_marker_from_gltf();
  EXPECT_EQ(m * glm::dvec4(1, 0, 0, 1), glm::dvec4(1, 0, 0, 1));  // right stays right
  EXPECT_EQ(m * glm::dvec4(0, 1, 0, 1), glm::dvec4(0, 0, 1, 1));  // up is out of the paper
  EXPECT_EQ(m * glm::dvec4(0, 0, 1, 1),
            glm::dvec4(0, -1, 0, 1));  // towards the marker's bottom edge
  EXPECT_DOUBLE_EQ(glm::determinant(m), 1.0);
}

TEST(Pose, UnusablePosesAreTold) {
  EXPECT_TRUE(is_usable(some_pose()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto usable = [](auto change) {
    MarkerPose pose = some_pose();
    change(pose);
    return is_usable(pose);
  };
  EXPECT_FALSE(usable([](MarkerPose& p) { p.rotation = glm::dquat(0, 0, 0, 0); }));
  EXPECT_FALSE(usable([](MarkerPose& p) { p.rotation *= 1.002; }));
  EXPECT_TRUE(usable([](MarkerPose& p) { p.rotation *= 1.0005; }));
  EXPECT_FALSE(usable([&](MarkerPose& p) { p.rotation.x = nan; }));
  EXPECT_FALSE(usable([&](MarkerPose& p) { p.translation.y = nan; }));
  EXPECT_FALSE(usable([](MarkerPose& p) { p.translation.z = 1e30; }));
  EXPECT_FALSE(
      usable([](MarkerPose& p) { p.translation.x = -std::numeric_limits<double>::infinity(); }));
}

TEST(Pose, MatrixNormalisesTheQuaternion) {
  MarkerPose pose = some_pose();
  pose.rotation *= 1.0005;
  EXPECT_NEAR(glm::determinant(to_matrix(pose)), 1.0, 1e-14);
}

}  // namespace
}  // namespace amalgam::common
