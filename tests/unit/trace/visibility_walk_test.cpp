#include "trace/visibility_walk.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<double> heights_met(const scene::Scene& scene, const Ray& ray) {
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  std::vector<double> heights;
  EXPECT_TRUE(walk_visibility(embree, glm::dvec3(ray.origin), ray, Visible::Everything,
                              [&](const SurfacePoint& point, double) {
                                heights.push_back(std::round(point.position.y * 1e6) / 1e6);
                                return std::optional(Visible::Everything);
                              }));
  return heights;
}

scene::Scene plates(float gap) {
  scene::Scene scene;
  for (int i = 0; i < 4; ++i) {
    test_support::add_object(scene, test_support::make_floor(gap * static_cast<float>(i), 100.0f),
                             test_support::make_glass(), scene::Role::Virtual);
  }
  return scene;
}

TEST(VisibilityWalk, MeetsEachSurfaceOnceNearestFirst) {
  const std::vector<double> met =
      heights_met(plates(0.25f), {{0.1f, 5, 0.2f}, {0, -1, 0}, kInfinity});
  EXPECT_EQ(met, (std::vector<double>{0.75, 0.5, 0.25, 0.0}));
}

// Light that grazes sheets a hundredth of a millimetre apart, 100 m wide: the offset that rays
// start with, along the ray, would step over all of them.
TEST(VisibilityWalk, LeavesNoneOutWhereItGrazesThem) {
  const glm::vec3 direction = glm::normalize(glm::vec3(1.0f, -1e-3f, 0.0f));
  EXPECT_EQ(heights_met(plates(1e-5f), {{-10.0f, 0.01f, 0.2f}, direction, kInfinity}).size(), 4u);
}

// Through the middle of a ball's edges, where Embree may meet both triangles: in and out, once
// each.
TEST(VisibilityWalk, MeetsAnEdgeOnce) {
  scene::Scene scene;
  test_support::add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 0.1f, 64, 32),
                           test_support::make_glass(), scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const scene::Mesh& ball = scene.meshes[0];
  const glm::dvec3 start(0.5, 0.31, 0.23);
  int wrong = 0;
  for (const glm::uvec3& corners : ball.triangles) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 a(ball.positions[corners[k]]), b(ball.positions[corners[(k + 1) % 3]]);
      const glm::vec3 direction(glm::normalize(0.5 * (a + b) - start));
      // At the silhouette in and out may be one point.
      if (std::abs(glm::dot(glm::normalize(a + b), glm::dvec3(direction))) < 0.05) continue;
      int in = 0, out = 0;
      walk_visibility(embree, start, {glm::vec3(start), direction, kInfinity}, Visible::Everything,
                      [&](const SurfacePoint& point, double) {
                        ++(point.front ? in : out);
                        return std::optional(Visible::Everything);
                      });
      wrong += in == 1 && out == 1 ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(VisibilityWalk, EndsWithTheRay) {
  EXPECT_EQ(heights_met(plates(0.25f), {{0.1f, 5, 0.2f}, {0, -1, 0}, 4.6f}),
            (std::vector<double>{0.75, 0.5}));
}

TEST(VisibilityWalk, StopsWhenToldAndLooksForWhatItIsTold) {
  scene::Scene scene = plates(0.25f);
  scene.instances[2].role = scene.instances[0].role = scene::Role::Real;
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  std::vector<double> heights;
  walk_visibility(embree, glm::dvec3(0.1f, 5, 0.2f), {{0.1f, 5, 0.2f}, {0, -1, 0}, kInfinity},
                  Visible::Everything,
                  [&](const SurfacePoint& point, double t) -> std::optional<Visible> {
                    EXPECT_NEAR(t, 5.0 - point.position.y, 1e-6);
                    heights.push_back(std::round(point.position.y * 1e6) / 1e6);
                    if (heights.size() == 2) return Visible::Real;
                    return Visible::Everything;
                  });
  EXPECT_EQ(heights, (std::vector<double>{0.75, 0.5, 0.0})) << "0.25 is virtual";
}

TEST(VisibilityWalk, GivesUpOnTooMany) {
  scene::Scene scene;
  scene::Mesh stack;
  for (int i = 0; i <= kMaxSurfacesOnWay; ++i) {
    const scene::Mesh floor = test_support::make_floor(0.01f * static_cast<float>(i), 1.0f);
    const auto first = static_cast<std::uint32_t>(stack.positions.size());
    stack.positions.insert(stack.positions.end(), floor.positions.begin(), floor.positions.end());
    stack.normals.insert(stack.normals.end(), floor.normals.begin(), floor.normals.end());
    for (const glm::uvec3& triangle : floor.triangles) stack.triangles.push_back(first + triangle);
  }
  test_support::add_object(scene, stack, test_support::make_glass(), scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const auto go_on = [](const SurfacePoint&, double) { return std::optional(Visible::Everything); };
  EXPECT_FALSE(walk_visibility(embree, glm::dvec3(0.1f, 9, 0.2f),
                               {{0.1f, 9, 0.2f}, {0, -1, 0}, kInfinity}, Visible::Everything,
                               go_on));
  EXPECT_TRUE(walk_visibility(embree, glm::dvec3(0.1f, 1, 0.2f),
                              {{0.1f, 1, 0.2f}, {0, -1, 0}, kInfinity}, Visible::Everything,
                              go_on));
}

}  // namespace
}  // namespace amalgam::trace
