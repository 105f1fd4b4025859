#include "trace/embree_scene.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "support/scene_builders.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(EmbreeScene, MeetsTheNearestAndTellsRealFromVirtual) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1.0f),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, test_support::make_floor(1.0f, 1.0f),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  EmbreeScene embree(scene);
  const Ray down{{0.1f, 3.0f, 0.2f}, {0, -1, 0}, kInfinity};
  EXPECT_FALSE(embree.intersect(down, Visible::Everything)) << "nothing is placed yet";
  embree.place(anchor_all(scene));
  const auto first = embree.intersect(down, Visible::Everything);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->instance, 1u);
  EXPECT_NEAR(first->t, 2.0, 1e-6);
  const auto real = embree.intersect(down, Visible::Real);
  ASSERT_TRUE(real);
  EXPECT_EQ(real->instance, 0u);
  EXPECT_TRUE(embree.is_occluded({{0, 3, 0}, {0, -1, 0}, 2.5f}, Visible::Everything));
  EXPECT_FALSE(embree.is_occluded({{0, 3, 0}, {0, -1, 0}, 2.5f}, Visible::Real));
}

TEST(EmbreeScene, MovesOnlyWhatMoved) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1.0f), test_support::make_mirror(),
             scene::Role::Virtual);
  EmbreeScene embree(scene);
  scene::AnchoredScene anchored = anchor_all(scene);
  EXPECT_FALSE(embree.is_placed(anchored));
  embree.place(anchored);
  EXPECT_TRUE(embree.is_placed(anchored));
  anchored.instances[0].world_from_mesh = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0.5f, 0));
  EXPECT_FALSE(embree.is_placed(anchored));
  embree.place(anchored);
  const auto hit = embree.intersect({{0, 2, 0}, {0, -1, 0}, kInfinity}, Visible::Everything);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.5, 1e-6);
  anchored.instances.clear();
  embree.place(anchored);
  EXPECT_FALSE(embree.intersect({{0, 2, 0}, {0, -1, 0}, kInfinity}, Visible::Everything));
}

// numerics B12: what is not a ray meets nothing, and crashes nothing.
TEST(EmbreeScene, RaysThatAreNotFiniteMeetNothing) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1.0f), test_support::make_mirror(),
             scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(embree.intersect({{nan, 1, 0}, {0, -1, 0}, kInfinity}, Visible::Everything));
  EXPECT_FALSE(embree.intersect({{0, 1, 0}, {0, -kInfinity, 0}, kInfinity}, Visible::Everything));
  EXPECT_FALSE(embree.is_occluded({{0, 1, 0}, {0, -1, 0}, nan}, Visible::Everything));
}

// numerics B11: no ray escapes from inside a closed mesh.
TEST(EmbreeScene, ClosedMeshIsWatertight) {
  scene::Scene scene;
  add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 1.0f, 64, 32),
             test_support::make_mirror(), scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  std::mt19937 random(2);
  std::normal_distribution<float> normal;
  int misses = 0;
  constexpr int kRays = 200000;
  for (int i = 0; i < kRays; ++i) {
    const glm::vec3 d = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    if (!embree.intersect({glm::vec3(0.01f, 0.02f, -0.03f), d, kInfinity}, Visible::Everything))
      ++misses;
  }
  EXPECT_EQ(misses, 0);
}

// B12: hits at 1e5 times the object's size.
TEST(EmbreeScene, HitsFromFarAway) {
  scene::Scene scene;
  add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
             test_support::make_mirror(), scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  for (float far = 1e1f; far < 1.5e5f; far *= 10.0f) {
    EXPECT_TRUE(embree.intersect({{far, 0.1f, 0.2f}, {-1, 0, 0}, kInfinity}, Visible::Everything))
        << far;
  }
}

}  // namespace
}  // namespace amalgam::trace
