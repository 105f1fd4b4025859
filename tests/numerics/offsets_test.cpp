// numerics B1, B2 and B5: the distance from a surface at which rays start again. Too little, and a
// ray meets its own surface; too much, and it skips thin gaps and thin glass.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "trace/surface_point.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

// Reflections in a mirror box two metres wide, its middle this far from the origin on each axis.
// Fewer than the limit means that rays got out through walls.
double share_of_bounces(double far) {
  constexpr int kSide = 48, kDepth = 8;
  const scene::Environment environment = constant_environment(1.0f);
  scene::Scene scene;
  add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
             test_support::make_mirror(), scene::Role::Virtual,
             glm::translate(glm::mat4(1.0f), glm::vec3(glm::dvec3(far))));
  const TraceResult result = trace_shot(scene, {.eye = glm::dvec3(far) + glm::dvec3(0.1, 0.2, 0.5),
                                                .target = glm::dvec3(far),
                                                .settings = {.max_depth = kDepth},
                                                .environment = &environment,
                                                .width = kSide,
                                                .height = kSide,
                                                .focal_length = 40});
  EXPECT_EQ(result.nonfinite, 0u);
  return static_cast<double>(result.counts.rays.reflection) / (kSide * kSide * kDepth);
}

TEST(Offsets, AMirrorBoxHoldsItsRaysUpToAHundredKilometres) {
  for (const double far : {0.0, 1.0, 1e2, 1e4, 1e5}) EXPECT_EQ(share_of_bounces(far), 1.0) << far;
  // Beyond: rays start 32 units in the last place of a float above the wall. At a thousand
  // kilometres those are 4 m, more than the box is wide.
  EXPECT_LT(share_of_bounces(1e6), 0.5);
}

// Whether a ray from a plate at this height, straight up, meets the one above it.
bool sees_gap(float height, float gap) {
  scene::Scene scene;
  for (const float at : {height, height + gap}) {
    add_object(scene, test_support::make_floor(at, 1e-3f), test_support::make_mirror(),
               scene::Role::Virtual);
  }
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const glm::vec3 up(0, 1, 0);
  const SurfacePoint lower = surface_point(embree, {0, 0, {0.3f, 0.3f}, 0.0f}, -up);
  const auto hit = embree.intersect({lower.ray_origin(up), up, 1e30f}, Visible::Everything);
  return hit && hit->instance == 1;
}

// The stated limit (ray_offset.h): gaps below 4e-6 of the largest coordinate are skipped.
TEST(Offsets, GapsAreSeenDownToAFourMillionthOfTheDistance) {
  for (const float height : {1e-2f, 1.0f, 1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f}) {
    for (const float times : {1.1f, 2.0f, 10.0f, 1000.0f}) {
      EXPECT_TRUE(sees_gap(height, times * 4e-6f * height)) << height << " times " << times;
    }
    EXPECT_FALSE(sees_gap(height, 0.9f * 32.0f / (1 << 23) * height)) << height;
  }
}

// numerics B5: what a pane transmits, for thicknesses down to the same limit.
TEST(Offsets, APaneTransmitsTheSameDownToTheLimit) {
  const auto transmitted = [](float thickness) {
    scene::Scene scene;
    add_object(scene, test_support::make_box({-1, -1, 0}, {1, 1, thickness}),
               test_support::make_glass(), scene::Role::Virtual);
    add_object(scene, test_support::make_quad({0, 0, -0.5f}, {3, 0, 0}, {0, 3, 0}), emitter(1.0f),
               scene::Role::Virtual);
    return trace_ray(scene, {0.1, 0.2, 2.0}, {0.1, 0.2, 0.0},
                     {.max_depth = 40, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact})
        .x;
  };
  for (const float thickness : {1.0f, 1e-2f, 1e-4f, 1e-5f}) {
    EXPECT_NEAR(transmitted(thickness), 0.923077f, 2e-6f) << thickness;
  }
  // Beyond: the ray that enters starts behind the back side, so the pane ends nowhere. One of its
  // two surfaces is missing, and what lies behind seems to lie in the glass, n^2 = 2.25 times
  // darker.
  EXPECT_NEAR(transmitted(1e-6f), 0.96f / 2.25f, 1e-6f);
}

}  // namespace
}  // namespace amalgam::trace
