#include "scene/gltf/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

glm::dmat4 turned_scale(const glm::dvec3& scale) {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, -1));
  return turn * glm::scale(glm::dmat4(1.0), scale) *
         glm::rotate(glm::dmat4(1.0), -1.9, glm::dvec3(0.3, 1, 1));
}

TEST(GltfTransform, ConditionIsTheRatioOfScales) {
  EXPECT_NEAR(condition_number(glm::dmat4(1.0)), 1.0, 1e-12);
  EXPECT_NEAR(condition_number(turned_scale({2, 5, 10})), 5.0, 1e-9);
  EXPECT_NEAR(condition_number(turned_scale({-3, 3, 3})), 1.0, 1e-9);  // mirrored
  EXPECT_NEAR(condition_number(turned_scale({1, 1e-3, 1e3})) / 1e6, 1.0, 1e-3);
  EXPECT_NEAR(condition_number(turned_scale(glm::dvec3(1e-20))), 1.0, 1e-9);
  EXPECT_GT(condition_number(turned_scale({1, 1, 0})), 1e6);
  EXPECT_EQ(condition_number(glm::dmat4(0.0)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(condition_number(glm::dmat4(std::numeric_limits<double>::quiet_NaN())),
            std::numeric_limits<double>::infinity());
}

// numerics B23.
TEST(GltfTransform, NearlySingularTransformsAreRefused) {
  EXPECT_NO_THROW(check_transform_usable(turned_scale({1, 1, 1e-5}), "n"));
  EXPECT_NO_THROW(check_transform_usable(turned_scale({1, 1, 1.0e-6}), "n"));
  EXPECT_THROW(check_transform_usable(turned_scale({1, 1, 0.9e-6}), "n"), SceneError);
  EXPECT_THROW(check_transform_usable(turned_scale(glm::dvec3(1e-20)), "n"), SceneError);
  // Embree inverts the transform in float: its determinant must not vanish.
  EXPECT_NO_THROW(check_transform_usable(turned_scale(glm::dvec3(1.1e-12)), "n"));
  EXPECT_THROW(check_transform_usable(turned_scale(glm::dvec3(0.9e-12)), "n"), SceneError);
  EXPECT_NO_THROW(check_transform_usable(turned_scale({1e-8, 1.1e-14, 1.1e-14}), "n"));
  EXPECT_THROW(check_transform_usable(turned_scale({1e-9, 1.1e-15, 1.1e-15}), "n"), SceneError);
  EXPECT_THROW(check_transform_usable(glm::translate(glm::dmat4(1.0), glm::dvec3(1e30, 0, 0)), "n"),
               SceneError);
}

TEST(GltfTransform, MatricesAreColumnMajorAndPartsAreTimesRotationTimesScale) {
  tinygltf::Node node;
  node.matrix = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1};
  EXPECT_EQ(parent_from_node(node)[3], glm::dvec4(10, 11, 12, 1));
  EXPECT_EQ(parent_from_node(node)[0], glm::dvec4(1, 2, 3, 0));
  tinygltf::Node parts;
  parts.translation = {1, 2, 3};
  parts.rotation = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};
  parts.scale = {2, 3, 4};
  const glm::dvec4 p = parent_from_node(parts) * glm::dvec4(1, 1, 1, 1);
  EXPECT_NEAR(p.x, 1 + 4, 1e-12);  // +Z goes to +X
  EXPECT_NEAR(p.y, 2 + 3, 1e-12);
  EXPECT_NEAR(p.z, 3 - 2, 1e-12);  // +X goes to -Z
}

}  // namespace
}  // namespace amalgam::scene
