// Embree ends the process where a ray or a box leaves the numbers that it was made for: about 1e18,
// also in the space of an instance. No scene that loads may get there (numerics B12, B23).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

#include "common/log.h"
#include "support/scene_builders.h"
#include "trace/embree_range.h"
#include "trace/embree_scene.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The largest and smallest transforms that the loader takes (scene/gltf/transform.cpp).
constexpr double kLargest = 1e11, kSmallest = 1e-9;

struct Placed {
  double scale = 1.0;
  glm::dvec3 at{0.0};
};

// A square that faces a ray from the origin, which aims at its middle.
std::optional<Hit> aim_at(const Placed& placed) {
  scene::Scene scene;
  add_object(scene, test_support::make_quad({}, {1, 0, 0}, {0, 1, 0}), test_support::make_mirror(),
             scene::Role::Virtual,
             glm::scale(glm::translate(glm::dmat4(1.0), placed.at), glm::dvec3(placed.scale)));
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const Ray ray{glm::vec3(0.0f), glm::vec3(glm::normalize(placed.at)), kInfinity};
  const auto hit = embree.intersect(ray, Visible::Everything);
  EXPECT_EQ(embree.is_occluded(ray, Visible::Everything), hit.has_value());
  EXPECT_EQ(embree.is_in_frame(0), is_traceable(anchor_all(scene).instances[0].world_from_mesh));
  return hit;
}

// The ray's start is 1e20 in the space of a tiny instance that is far away. Such an instance is
// left out; a nanometre at a thousand kilometres is not.
TEST(EmbreeRange, TinyAndFarAway) {
  for (const double scale : {kSmallest, 1e-7, 1e-3, 1.0}) {
    for (const double distance : {1.0, 1e3, 1e6, 1e8, 1e9, kLargest}) {
      const bool in_range = distance / scale < 0.9e18;
      const auto hit = aim_at({scale, {0.0, 0.0, -distance}});
      ASSERT_EQ(hit.has_value(), in_range) << scale << " at " << distance;
      if (!hit) continue;
      EXPECT_NEAR(hit->t, distance, 1e-6 * distance);
    }
  }
}

// Its neighbours stay.
TEST(EmbreeRange, OneIsLeftOutAlone) {
  scene::Scene scene;
  for (const auto& [scale, distance] : {std::pair(1.0, 2.0), {kSmallest, kLargest}}) {
    add_object(
        scene, test_support::make_quad({}, {1, 0, 0}, {0, 1, 0}), test_support::make_mirror(),
        scene::Role::Virtual,
        glm::scale(glm::translate(glm::dmat4(1.0), {0.0, 0.0, -distance}), glm::dvec3(scale)));
  }
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  EXPECT_TRUE(embree.is_placed(anchor_all(scene)));
  EXPECT_TRUE(embree.is_in_frame(0));
  EXPECT_FALSE(embree.is_in_frame(1));
  EXPECT_TRUE(embree.intersect({glm::vec3(0.0f), {0, 0, -1}, kInfinity}, Visible::Everything));
}

TEST(EmbreeRange, HugeAndAround) {
  for (const double scale : {1e6, 1e9, kLargest}) {
    const auto hit = aim_at({scale, {0.0, 0.0, -1.0}});
    ASSERT_TRUE(hit) << scale;
    EXPECT_NEAR(hit->t, 1.0, 1e-5) << scale;
  }
}

// Anything within the limits, with rays that aim at it and rays that do not. Meshes may have any
// floats as coordinates.
TEST(EmbreeRange, AnythingThatLoads) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> unit;
  std::normal_distribution<double> normal;
  const auto power = [&](double low, double high) {
    return std::pow(10.0, low + (high - low) * unit(random));
  };
  const auto anywhere = [&](double length) {
    return length * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
  };
  common::set_log_level("error");  // thousands are too tiny, and named
  int hits = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    scene::Scene scene;
    const double extent = power(-30, 38);
    scene::Mesh mesh = test_support::make_sphere(glm::vec3(0.0f), 1.0f, 6, 5);
    for (glm::vec3& p : mesh.positions) p *= static_cast<float>(extent);
    const double scale = power(-9, 11);
    glm::dmat4 placed(glm::mat4_cast(glm::normalize(
        glm::dquat(normal(random), normal(random), normal(random), normal(random)))));
    for (int i = 0; i < 3; ++i) {
      placed[i] *= std::clamp(scale * power(-3, 3), 1e-12, kLargest);
    }
    placed[3] = glm::dvec4(anywhere(power(-3, 11)), 1.0);
    add_object(scene, mesh, test_support::make_mirror(), scene::Role::Virtual, glm::mat4(placed));
    EmbreeScene embree(scene);
    embree.place(anchor_all(scene));
    for (int i = 0; i < 20; ++i) {
      const glm::vec3 origin(anywhere(power(-6, 11.9)));
      const glm::vec3 to = i % 2 == 0 ? glm::vec3(placed[3]) - origin : glm::vec3(anywhere(1.0));
      const Ray ray{origin, glm::normalize(to), kInfinity};
      const auto hit = embree.intersect(ray, Visible::Everything);
      hits += hit ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 1000);
  common::set_log_level("info");
}

}  // namespace
}  // namespace amalgam::trace
