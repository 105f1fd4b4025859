#include "scene/anchored_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace amalgam::scene {
namespace {

common::MarkerPose pose_of(int marker, const glm::dvec3& translation) {
  common::MarkerPose pose;
  pose.marker = marker;
  pose.rotation = glm::normalize(glm::dquat(0.2, 0.9, -0.1, 0.1));
  pose.translation = translation;
  return pose;
}

// One object on the world marker 40, one on marker 23, one on marker 7.
Scene three_markers() {
  Scene scene;
  scene.world.marker = 40;
  scene.instances.resize(3);
  scene.instances[0].anchor_from_mesh[3] = glm::vec4(0.1f, 0.2f, 0.3f, 1.0f);
  scene.instances[1].marker = 23;
  scene.instances[2].marker = 7;
  return scene;
}

TEST(AnchoredScene, WithoutPosesNothingIsAnchored) {
  EXPECT_TRUE(anchor_scene(three_markers(), {}).instances.empty());
}

TEST(AnchoredScene, PosesOfOtherMarkersAreIgnored) {
  const common::MarkerPose poses[] = {pose_of(99, {0, 0, 1})};
  EXPECT_TRUE(anchor_scene(three_markers(), poses).instances.empty());
}

TEST(AnchoredScene, OnlyWhatStandsOnSeenMarkersIsAnchored) {
  const common::MarkerPose poses[] = {pose_of(40, {0, 0, 1}), pose_of(7, {0.2, 0, 1})};
  const AnchoredScene anchored = anchor_scene(three_markers(), poses);
  EXPECT_EQ(anchored.world_marker, 40);
  ASSERT_EQ(anchored.instances.size(), 2u);
  EXPECT_EQ(anchored.instances[0].instance, 0u);
  EXPECT_EQ(anchored.instances[1].instance, 2u);
}

TEST(AnchoredScene, TheWorldMarkersObjectsDoNotMoveAtAll) {
  const Scene scene = three_markers();
  for (const double x : {0.1, 0.123456789}) {
    const common::MarkerPose poses[] = {pose_of(40, {x, 0, 1})};
    const AnchoredScene anchored = anchor_scene(scene, poses);
    EXPECT_EQ(anchored.instances[0].world_from_mesh,
              glm::mat4(scene.instances[0].anchor_from_mesh));
  }
}

TEST(AnchoredScene, EveryObjectIsWhereItsOwnMarkerIs) {
  const common::MarkerPose poses[] = {pose_of(40, {0, 0, 1}), pose_of(23, {0.3, -0.1, 1.2})};
  const AnchoredScene anchored = anchor_scene(three_markers(), poses);
  ASSERT_EQ(anchored.instances.size(), 2u);
  const glm::dvec4 seen = anchored.camera_from_world *
                          glm::dmat4(anchored.instances[1].world_from_mesh) *
                          glm::dvec4(0, 0, 0, 1);
  EXPECT_LT(glm::length(glm::dvec3(seen) - glm::dvec3(0.3, -0.1, 1.2)), 1e-6);
}

TEST(AnchoredScene, AnotherMarkerStandsInForTheWorld) {
  const common::MarkerPose poses[] = {pose_of(23, {0.3, 0, 1}), pose_of(7, {0, 0, 1})};
  const AnchoredScene anchored = anchor_scene(three_markers(), poses);
  EXPECT_EQ(anchored.world_marker, 7);
  EXPECT_EQ(anchored.instances.size(), 2u);
}

// numerics B13: what stands far from its marker keeps its place to a float's last digit near 0.
TEST(AnchoredScene, TheOriginIsAtObjectsFarFromTheirMarker) {
  Scene scene = three_markers();
  PunctualLight light;
  light.anchor_from_light[3] = glm::dvec4(1e6 + 0.2, 0, 2, 1);
  scene.punctual_lights = {light};
  scene.instances[0].anchor_from_mesh[3] = glm::dvec4(1e6 + 0.1, -0.2, 0.3, 1.0);
  const common::MarkerPose poses[] = {pose_of(40, {0.2, 0.3, 1.0}), pose_of(7, {0.4, 0, 1})};
  const AnchoredScene anchored = anchor_scene(scene, poses);
  EXPECT_EQ(anchored.world_origin, glm::dvec3(1e6, 0, 0));
  const glm::dvec3 placed(anchored.instances[0].world_from_mesh[3]);
  EXPECT_LT(glm::distance(placed, glm::dvec3(0.1, -0.2, 0.3)), 1e-7);
  EXPECT_LT(glm::distance(glm::dvec3(anchored.punctual_lights[0].position), {0.2, 0, 2}), 1e-7);
  // Everything is where it was as seen by the camera, also what stands on another marker.
  const glm::dmat4 camera_from_anchor =
      common::to_matrix(poses[0]) * common::opencv_marker_from_gltf();
  const glm::dvec3 expected(camera_from_anchor * scene.instances[0].anchor_from_mesh[3]);
  EXPECT_LT(glm::distance(glm::dvec3(anchored.camera_from_world * glm::dvec4(placed, 1)), expected),
            1e-6);
  const glm::dvec4 other(anchored.instances[1].world_from_mesh[3]);
  EXPECT_LT(glm::distance(glm::dvec3(anchored.camera_from_world * other), {0.4, 0, 1}), 0.1);
}

TEST(AnchoredScene, UnusablePosesAreIgnored) {
  common::MarkerPose bad = pose_of(40, {0, 0, 1});
  bad.translation.x = std::numeric_limits<double>::quiet_NaN();
  const common::MarkerPose poses[] = {bad};
  EXPECT_TRUE(anchor_scene(three_markers(), poses).instances.empty());
}

TEST(AnchoredScene, PunctualLightsComeAlong) {
  Scene scene = three_markers();
  PunctualLight light;
  light.kind = PunctualLight::Kind::Spot;
  light.intensity = {1, 2, 3};
  light.anchor_from_light[3] = glm::vec4(0, 1, 0, 1);
  scene.punctual_lights = {light, light};
  scene.punctual_lights[1].marker = 23;
  const common::MarkerPose poses[] = {pose_of(40, {0, 0, 1})};
  const AnchoredScene anchored = anchor_scene(scene, poses);
  ASSERT_EQ(anchored.punctual_lights.size(), 1u);
  EXPECT_EQ(anchored.punctual_lights[0].kind, Light::Kind::Spot);
  EXPECT_EQ(anchored.punctual_lights[0].to_light, glm::vec3(0, 0, 1));  // it shines along its -Z
  EXPECT_EQ(anchored.punctual_lights[0].position, glm::vec3(0, 1, 0));
  EXPECT_EQ(anchored.punctual_lights[0].intensity, glm::vec3(1, 2, 3));
}

}  // namespace
}  // namespace amalgam::scene
