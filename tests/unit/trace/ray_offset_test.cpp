#include "trace/ray_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "support/scene_builders.h"
#include "trace/embree_scene.h"
#include "trace/surface_point.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

scene::Mesh one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  scene::Mesh mesh;
  mesh.positions = {a, b, c};
  const auto normal = glm::vec3(glm::normalize(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a))));
  mesh.normals = {normal, normal, normal};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

// B1: a ray that leaves a triangle does not meet it again, for triangles of sizes and distances
// over wide exponents.
TEST(RayOffset, LeavesItsTriangle) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f), exponent(-3.0f, 4.0f);
  int again = 0;
  for (int t = 0; t < 1000; ++t) {
    const float size = std::pow(10.0f, exponent(random)), far = std::pow(10.0f, exponent(random));
    const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    const glm::vec3 centre = far * vector();
    const glm::vec3 a = centre + size * vector(), b = centre + size * vector(),
                    c = centre + size * vector();
    const glm::vec3 area = glm::cross(b - a, c - a);
    // Slivers that float cannot tell from a line have no normal to leave along.
    if (!(glm::length(area) > 1e-3f * size * size) || far > 1e4f * size) continue;
    scene::Scene scene;
    add_object(scene, one_triangle(a, b, c), test_support::make_mirror(), scene::Role::Virtual);
    EmbreeScene embree(scene);
    scene::AnchoredScene anchored;
    anchored.instances = {{0, glm::mat4(1.0f)}};
    embree.place(anchored);
    for (int r = 0; r < 1000; ++r) {
      float u = 0.5f * (unit(random) + 1.0f), v = 0.5f * (unit(random) + 1.0f);
      if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
      const glm::vec3 direction = glm::normalize(vector() + glm::vec3(1e-3f));
      const SurfacePoint point = surface_point(embree, {0, 0, {u, v}, 0.0f}, -direction);
      const Ray ray{point.ray_origin(direction), direction, 1e30f};
      if (embree.intersect(ray, Visible::Everything)) ++again;
    }
  }
  EXPECT_EQ(again, 0);
}

TEST(RayOffset, LeavesToTheSideOfTheRay) {
  const glm::vec3 p(1, 2, 3), up(0, 1, 0);
  for (const glm::vec3& normal : {up, -up}) {
    EXPECT_GT(offset_from_surface(p, normal, {0.6f, 0.8f, 0}, 1e-3f).y, p.y);
    EXPECT_LT(offset_from_surface(p, normal, {0.6f, -0.8f, 0}, 1e-3f).y, p.y);
  }
}

// numerics B2: the gap between two plates is seen from 4e-5 on at 1 m from the origin, and from
// 2e-2 on at 1 km.
TEST(RayOffset, SeesGapsDownToItsResolution) {
  for (const auto& [far, gap] : {std::pair{1.0f, 4e-5f}, std::pair{1000.0f, 2e-2f}}) {
    scene::Scene scene;
    add_object(scene, test_support::make_floor(far, 1.0f), test_support::make_mirror(),
               scene::Role::Virtual);
    add_object(scene, test_support::make_floor(far + gap, 1.0f), test_support::make_mirror(),
               scene::Role::Virtual);
    EmbreeScene embree(scene);
    scene::AnchoredScene anchored;
    anchored.instances = {{0, glm::mat4(1.0f)}, {1, glm::mat4(1.0f)}};
    embree.place(anchored);
    const glm::vec3 up(0, 1, 0);
    const SurfacePoint lower = surface_point(embree, {0, 0, {0.3f, 0.3f}, 0.0f}, -up);
    const auto hit = embree.intersect({lower.ray_origin(up), up, 1e30f}, Visible::Everything);
    ASSERT_TRUE(hit) << far;
    EXPECT_EQ(hit->instance, 1u);
  }
}

}  // namespace
}  // namespace amalgam::trace
