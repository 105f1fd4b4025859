// The camera within glass or water: its rays start in that medium.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "trace/media_at.h"
#include "unit/trace/glass_meshes.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_box;
using test_support::make_glass;
using test_support::make_quad;

constexpr double kDegree = std::numbers::pi / 180.0;
const glm::vec3 kAbsorption(0.2f, 1.0f, 3.0f);
// What is outside has n^2 times its radiance within (Tile::light_weight).
constexpr float kInGlass = 1.5f * 1.5f;
// Up to the lamp or target, without inner bounces.
TraceSettings surfaces_met(int count) {
  return {.max_depth = count, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};
}

void add_target(scene::Scene& scene, const glm::dvec3& at) {
  constexpr float kHalf = 1e-4f;
  add_object(scene, make_quad(glm::vec3(at), {kHalf, 0, 0}, {0, kHalf, 0}), emitter(1.0f),
             scene::Role::Virtual);
}

void add_lamp(scene::Scene& scene, float z) {
  add_object(scene, make_quad({0, 0, z}, {9, 0, 0}, {0, 9, 0}), emitter(1.0f),
             scene::Role::Virtual);
}

double sine_beyond(double degrees, double from, double into) {
  return from / into * std::sin(degrees * kDegree);
}

TEST(CameraInMedium, LooksOutBySnellAndFresnel) {
  for (const double degrees : {0.0, 20.0, 40.0}) {
    const double sine = sine_beyond(degrees, 1.5, 1.0);
    scene::Scene scene;
    add_object(scene, make_box({-3, -3, 0}, {3, 3, 2}), make_glass(1.5f), scene::Role::Virtual);
    const glm::dvec3 leaves(0.1, 0.2, 0.0);
    const glm::dvec3 in(std::sin(degrees * kDegree), 0.0, -std::cos(degrees * kDegree));
    const glm::dvec3 out(sine, 0.0, -std::sqrt(1.0 - sine * sine));
    add_target(scene, leaves + 2.0 * out);
    EXPECT_NEAR(trace_ray(scene, leaves - in, leaves, surfaces_met(1)).x,
                1.5 * 1.5 * (1.0 - reflectance_exact(std::cos(degrees * kDegree), 1.5, 1.0)), 2e-5)
        << degrees;
  }
}

// Beer-Lambert on the way from the camera, and on the way back of what the surface reflects.
TEST(CameraInMedium, ItsMediumAbsorbs) {
  scene::Scene scene;
  add_object(scene, make_box({-3, -3, 0}, {3, 3, 2}), make_glass(1.5f, kAbsorption),
             scene::Role::Virtual);
  add_lamp(scene, -1.0f);
  const glm::vec3 ahead = trace_ray(scene, {0.1, 0.2, 0.7}, {0.1, 0.2, 0.0}, surfaces_met(1));
  EXPECT_LT(glm::distance(ahead, kInGlass * 0.96f * glm::exp(-0.7f * kAbsorption)), 2e-6f);

  scene::Scene behind;
  add_object(behind, make_box({-3, -3, 0}, {3, 3, 2}), make_glass(1.5f, kAbsorption),
             scene::Role::Virtual);
  add_lamp(behind, 3.0f);
  const glm::vec3 reflected = trace_ray(behind, {0.1, 0.2, 0.7}, {0.1, 0.2, 0.0}, surfaces_met(2));
  EXPECT_LT(glm::distance(reflected, kInGlass * 0.04f * 0.96f * glm::exp(-2.7f * kAbsorption)),
            2e-6f);
}

// In water in a vessel, both with the water reaching a little into the wall and with a gap: the way
// out leads through water, glass and air.
TEST(CameraInMedium, LooksOutOfWaterThroughGlass) {
  const double degrees = 30.0, step = 0.01;
  for (const double margin : {step, -step}) {
    const auto m = static_cast<float>(margin);
    scene::Scene scene;
    add_object(scene, make_box({-3, -3, 0}, {3, 3, 3}), make_glass(1.5f), scene::Role::Virtual);
    add_to_last_material(scene,
                         turned_inside_out(make_box({-2.5f, -2.5f, 0.5f}, {2.5f, 2.5f, 2.5f})));
    add_object(scene, make_box(glm::vec3(-2.5f - m, -2.5f - m, 0.5f - m), glm::vec3(2.5f + m)),
               make_glass(1.33f, kAbsorption), scene::Role::Virtual);
    const double in = degrees * kDegree, gap = margin < 0.0 ? step : 0.0;
    const double in_glass = std::asin(sine_beyond(degrees, 1.33, 1.5)),
                 in_air = std::asin(sine_beyond(degrees, 1.33, 1.0));
    // From the eye at z = 1 through the water, the gap and 0.5 m of wall.
    const double water = 0.5 - gap;
    const glm::dvec3 eye(0.1, 0.2, 1.0);
    const double x = 0.1 + water * std::tan(in) + gap * std::tan(in_air) + 0.5 * std::tan(in_glass);
    add_target(scene, glm::dvec3(x, 0.2, 0.0) + glm::dvec3(std::sin(in_air), 0, -std::cos(in_air)));
    double surfaces = 1.33 * 1.33 * (1.0 - reflectance_exact(std::cos(in_glass), 1.5, 1.0));
    if (gap > 0.0) {
      surfaces *= (1.0 - reflectance_exact(std::cos(in), 1.33, 1.0)) *
                  (1.0 - reflectance_exact(std::cos(in_air), 1.0, 1.5));
    } else {
      surfaces *= 1.0 - reflectance_exact(std::cos(in), 1.33, 1.5);
    }
    const glm::vec3 seen =
        trace_ray(scene, eye, eye + glm::dvec3(std::tan(in), 0.0, -1.0), surfaces_met(3));
    for (int c = 0; c < 3; ++c) {
      const double absorbed = std::exp(-water / std::cos(in) * double{kAbsorption[c]});
      EXPECT_NEAR(seen[c], surfaces * absorbed, 1e-5) << margin << " channel " << c;
    }
  }
}

// In an air bubble in glass, in both modellings.
TEST(CameraInMedium, LooksOutOfABubble) {
  for (const bool cavity : {false, true}) {
    scene::Scene scene;
    add_object(scene, make_box({-3, -3, 0}, {3, 3, 3}), make_glass(1.5f, kAbsorption),
               scene::Role::Virtual);
    const scene::Mesh bubble = make_box({-1, -1, 0.5f}, {1, 1, 1.5f});
    if (cavity) {
      add_to_last_material(scene, turned_inside_out(bubble));
    } else {
      add_object(scene, bubble, make_glass(1.0f), scene::Role::Virtual);
    }
    add_lamp(scene, -1.0f);
    const glm::vec3 seen = trace_ray(scene, {0.1, 0.2, 1.0}, {0.1, 0.2, 0.0}, surfaces_met(2));
    EXPECT_LT(glm::distance(seen, 0.96f * 0.96f * glm::exp(-0.5f * kAbsorption)), 2e-6f) << cavity;
  }
}

// An open surface encloses nothing, on whichever side of the camera it lies.
TEST(CameraInMedium, BehindAnOpenSheetThereIsNone) {
  const glm::vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    for (const float side : {1.0f, -1.0f}) {
      const glm::vec3 away = side * axes[i];  // also the sheet's normal
      scene::Scene scene;
      add_object(scene, make_quad(away, 3.0f * axes[(i + 1) % 3], 3.0f * side * axes[(i + 2) % 3]),
                 make_glass(1.5f, kAbsorption), scene::Role::Virtual);
      EmbreeScene embree(scene);
      embree.place(anchor_all(scene));
      EXPECT_FALSE(media_at(embree, {0.1f, 0.2f, 0.3f}).innermost()) << i << " " << side;
    }
  }
}

// What the camera sees directly of diffuse surfaces is the rasteriser's as well, which knows no
// media: both show the same.
TEST(CameraInMedium, DiffuseSurfacesSeenDirectlyAreAsTheRasteriserDrawsThem) {
  scene::Scene scene;
  add_object(scene, make_box({-3, -3, 0}, {3, 3, 2}), make_glass(1.5f, kAbsorption),
             scene::Role::Virtual);
  add_lamp(scene, 0.5f);
  EXPECT_EQ(trace_ray(scene, {0.1, 0.2, 1.0}, {0.1, 0.2, 0.0}, surfaces_met(1)), glm::vec3(1.0f));
}

}  // namespace
}  // namespace amalgam::trace
