#include "tracking/pose_tracker.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "common/camera_model.h"

namespace amalgam::tracking {
namespace {

const common::CameraModel kCamera = common::default_camera(640, 480);

common::MarkerPose facing(double x, double z) {
  // Turned about x by 180 degrees, so that the marker's z points back to the camera.
  return {.marker = 0, .rotation = {0.0, 1.0, 0.0, 0.0}, .translation = {x, 0.0, z}};
}

DetectedMarker seen(int id, const common::MarkerPose& pose) {
  return {.id = id, .corners = project_square(pose, 0.05, kCamera).value()};
}

TEST(PoseTracker, GivesThePosesThatTheCornersShow) {
  PoseTracker tracker({}, kCamera);
  const std::vector<DetectedMarker> detected{seen(7, facing(0.05, 0.4)), seen(3, facing(-0.1, 0.5))};
  const auto poses = tracker.track(detected);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].marker, 3);
  EXPECT_NEAR(glm::distance(poses[0].translation, glm::dvec3(-0.1, 0.0, 0.5)), 0.0, 1e-5);
  EXPECT_EQ(poses[1].marker, 7);
  EXPECT_NEAR(glm::distance(poses[1].translation, glm::dvec3(0.05, 0.0, 0.4)), 0.0, 1e-5);
}

TEST(PoseTracker, LeavesOutMarkersThatNobodyAskedFor) {
  PoseTracker tracker({.ids = {3}}, kCamera);
  EXPECT_FALSE(tracker.wants(7));
  EXPECT_TRUE(tracker.track(std::vector{seen(7, facing(0.0, 0.4))}).empty());
  EXPECT_EQ(tracker.track(std::vector{seen(3, facing(0.0, 0.4))}).size(), 1u);
}

// Two prints of one marker: the object stays with the one that it stood on.
TEST(PoseTracker, OfRepeatedMarkersTakesTheOneNearestToTheLast) {
  PoseTracker tracker({}, kCamera);
  tracker.track(std::vector{seen(3, facing(0.1, 0.6))});
  const auto poses =
      tracker.track(std::vector{seen(3, facing(-0.1, 0.4)), seen(3, facing(0.11, 0.6))});
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_NEAR(poses[0].translation.x, 0.11, 1e-5);
  EXPECT_EQ(tracker.counts().repeated, 1u);
}

TEST(PoseTracker, CountsCornersWithoutAPose) {
  PoseTracker tracker({}, kCamera);
  DetectedMarker flat{.id = 3, .corners = {}};
  for (int i = 0; i < 4; ++i) flat.corners[static_cast<std::size_t>(i)] = {100.0 + i, 100.0};
  EXPECT_TRUE(tracker.track(std::vector{flat}).empty());
  EXPECT_EQ(tracker.counts().unsolved, 1u);
}

TEST(PoseTracker, RefusesALengthThatIsNone) {
  EXPECT_THROW(PoseTracker({.marker_length = 0.0}, kCamera), std::runtime_error);
}

}  // namespace
}  // namespace amalgam::tracking
