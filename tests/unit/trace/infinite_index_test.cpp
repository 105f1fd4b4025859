// KHR_materials_ior's index of 0 stands for infinity: all light is reflected, from either side and
// within other media. The loader makes such a material a white mirror
// (tests/unit/scene/gltf_textures_test.cpp).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "trace/shadow.h"
#include "unit/trace/furnace.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_quad;

scene::Material infinite_index() {
  scene::Material material = test_support::make_mirror();
  material.ior = 0.0f;
  return material;
}

const TraceSettings kExact{
    .max_depth = 3, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};

// Before the sheet is one lamp, behind it another: at all angles the eye sees what is on its side.
TEST(InfiniteIndex, ReflectsAllFromEitherSide) {
  scene::Scene scene;
  add_object(scene, make_quad(glm::vec3(0.0f), {50, 0, 0}, {0, 1, 0}), infinite_index(),
             scene::Role::Virtual);
  add_object(scene, make_quad({0, 0, 2}, {90, 0, 0}, {0, 9, 0}), emitter(0.25f),
             scene::Role::Virtual);
  add_object(scene, make_quad({0, 0, -2}, {90, 0, 0}, {0, 9, 0}), emitter(0.75f),
             scene::Role::Virtual);
  for (const double side : {1.0, -1.0}) {
    for (const double x : {0.0, 0.5, 5.0, 20.0}) {
      const glm::dvec3 eye(-x, 0.1, side);
      EXPECT_EQ(trace_ray(scene, eye, {0.0, 0.1, 0.0}, kExact), glm::vec3(side > 0 ? 0.25f : 0.75f))
          << x;
    }
  }
}

// A ray at 45 degrees through 0.5 m of glass onto the sheet comes back out beside where it went in.
// The target is 0.2 mm wide.
TEST(InfiniteIndex, ReflectsAllWithinGlass) {
  const double angle = std::numbers::pi / 4.0, inside = std::asin(std::sin(angle) / 1.5);
  const glm::dvec3 enters(0.1, 0.2, 0.0), in(std::sin(angle), 0.0, -std::cos(angle)),
      out(in.x, 0.0, -in.z);
  const glm::dvec3 leaves = enters + glm::dvec3(2.0 * 0.5 * std::tan(inside), 0.0, 0.0);
  constexpr float kHalf = 1e-4f;
  scene::Scene scene;
  add_object(scene, test_support::make_box({-3, -3, -1}, {3, 3, 0}), test_support::make_glass(),
             scene::Role::Virtual);
  add_object(scene, make_quad({0, 0, -0.5f}, {2, 0, 0}, {0, 2, 0}), infinite_index(),
             scene::Role::Virtual);
  add_object(scene, make_quad(glm::vec3(leaves + out), {kHalf, 0, 0}, {0, kHalf, 0}), emitter(1.0f),
             scene::Role::Virtual);
  const double surface = 1.0 - reflectance_exact(std::cos(angle), 1.0, 1.5);
  EXPECT_NEAR(trace_ray(scene, enters - in, enters, kExact).x, surface * surface, 1e-5);
}

// Balls within a ball, in a furnace: whatever the rays do, nothing is lost.
TEST(InfiniteIndex, LosesNothingInNestedMedia) {
  scene::Scene scene;
  const auto ball = [&](float radius, const scene::Material& material) {
    add_object(scene, test_support::make_sphere(glm::vec3(0.0f), radius, 20, 10), material,
               scene::Role::Virtual);
  };
  ball(1.0f, test_support::make_glass(1.5f));
  ball(0.8f, test_support::make_glass(1.33f));
  ball(0.5f, infinite_index());
  const scene::Environment furnace = constant_environment(1.0f);
  const TraceResult result =
      trace_shot(scene, {.environment = &furnace, .width = 40, .height = 40, .focal_length = 30});
  for (std::size_t i = 0; i < result.images->mixed.pixels().size(); ++i) {
    if (result.images->met_virtual.pixels()[i] == 0) continue;
    ASSERT_NEAR(result.images->mixed.pixels()[i].x, 1.0f, kFurnaceBound) << i;
  }
}

TEST(InfiniteIndex, CastsAFullShadow) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(1.0f, 1.0f), infinite_index(), scene::Role::Real);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const float infinity = std::numeric_limits<float>::infinity();
  PassedSurfaces surfaces;
  EXPECT_EQ(trace_shadow(embree, glm::dvec3(0.1f, 0, 0.2f), {{0.1f, 0, 0.2f}, {0, 1, 0}, infinity},
                         surfaces)
                .real,
            glm::vec3(0.0f));
}

}  // namespace
}  // namespace amalgam::trace
