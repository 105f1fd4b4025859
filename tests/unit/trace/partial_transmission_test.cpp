// Glass that lets only a share of the light through: k_s is reflected, (1 - k_s) t goes on through
// the surface, colored by the base color, and (1 - k_s) (1 - t) it scatters back diffusely.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "unit/trace/glass_meshes.h"
#include "unit/trace/halves_texture.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_box;
using test_support::make_quad;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kR = 0.04f;  // of n = 1.5, straight on
const glm::vec3 kColor(0.9f, 0.5f, 0.2f), kIrradiance(2.0f, 3.0f, 4.0f);
constexpr float kLamp = 0.7f;
constexpr float kCosine = 0.70710678f;  // of the sun, 45 degrees from the way to the eye
const glm::vec3 kScattered = kColor * kIrradiance * (kCosine / kPi);  // by all of a lit surface

scene::Material frosted(float transmission, bool thin) {
  scene::Material material = test_support::make_glass(1.5f);
  material.base_color = glm::vec4(kColor, 1.0f);
  material.transmission = transmission;
  material.thin = thin;
  return material;
}

// Seen straight on from +z, with a lamp behind it.
glm::vec3 seen_through(scene::Scene scene, int max_depth, float x = 0.1f) {
  add_object(scene, make_quad({0, 0, -2}, {9, 0, 0}, {0, 9, 0}), emitter(kLamp),
             scene::Role::Virtual);
  return centre(trace_shot(scene, {.eye = {x, 0.23, 3.0},
                                   .target = {x, 0.23, 0.0},
                                   .settings = {.max_depth = max_depth, .importance_cutoff = 0.0f},
                                   .lights = {test_support::make_sun({1, 0, 1}, kIrradiance)},
                                   .width = 1,
                                   .height = 1}));
}

TEST(PartialTransmission, SharesOfAThinSheetAddUp) {
  const float through = 1.0f - 2.0f * kR / (1.0f + kR);
  for (const float t : {0.0f, 0.5f, 0.8f, 1.0f}) {
    scene::Scene scene;
    add_object(scene, make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}), frosted(t, true),
               scene::Role::Virtual);
    const glm::vec3 expected = through * (t * kColor * kLamp + (1.0f - t) * kScattered);
    EXPECT_LT(glm::distance(seen_through(scene, 1), expected), 1e-6f) << t;
  }
}

// Both surfaces scatter: the first the sun itself, the second what the first lets in (without
// bending it, by Schlick's reflectance at 45 degrees).
TEST(PartialTransmission, SharesOfASolidAddUpAtBothSurfaces) {
  constexpr float kSquaredIndex = 1.5f * 1.5f;
  const float sun_gets_in = 1.0f - (kR + (1.0f - kR) * std::pow(1.0f - kCosine, 5.0f));
  for (const float t : {0.5f, 0.8f, 1.0f}) {
    scene::Scene scene;
    add_object(scene, make_box({-3, -3, -0.4f}, {3, 3, 0}), frosted(t, false),
               scene::Role::Virtual);
    const glm::vec3 way_in = (1.0f - kR) * t * kColor;
    const glm::vec3 at_first = (1.0f - kR) * (1.0f - t) * kScattered;
    const glm::vec3 at_second =
        way_in / kSquaredIndex *  // it lies in the glass
        ((1.0f - kR) * (1.0f - t) * kScattered * (t * kColor * sun_gets_in));
    const glm::vec3 expected = at_first + at_second + way_in * way_in * kLamp;
    EXPECT_LT(glm::distance(seen_through(scene, 2), expected), 2e-6f) << t;
  }
}

// Opaque and rough as clay, it looks like clay, though its kind is glass: no mirror image.
TEST(PartialTransmission, WhatIsRoughAndLetsNothingThroughIsAsAnOpaqueSurface) {
  for (const bool thin : {true, false}) {
    scene::Material glass = frosted(0.0f, thin);
    glass.roughness = 0.6f;
    const scene::Mesh box = make_box({-3, -3, -0.4f}, {3, 3, 0});
    scene::Scene as_glass, as_clay;
    add_object(as_glass, box, glass, scene::Role::Virtual);
    add_object(as_clay, box, test_support::make_diffuse(kColor, 0.6f), scene::Role::Virtual);
    const glm::vec3 expected = seen_through(as_clay, 2);
    EXPECT_GT(expected.x, 0.1f);
    EXPECT_LT(glm::distance(seen_through(as_glass, 2), expected), 1e-6f) << thin;
  }
}

// The left half of the texture lets a fifth through, the right half all.
TEST(PartialTransmission, TheTextureMultipliesTheFactor) {
  scene::Scene scene;
  scene::Material material = frosted(0.8f, true);
  material.transmission_texture = add_halves(scene, {51, 0, 0, 255}, {255, 0, 0, 255});
  add_object(scene, make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}), material,
             scene::Role::Virtual);
  const float through = 1.0f - 2.0f * kR / (1.0f + kR);
  for (const auto& [x, t] : {std::pair{-0.5f, 0.8f * 0.2f}, {0.5f, 0.8f}}) {
    const glm::vec3 expected = through * (t * kColor * kLamp + (1.0f - t) * kScattered);
    EXPECT_LT(glm::distance(seen_through(scene, 1, x), expected), 1e-6f) << x;
  }
}

// Points spread evenly over the sphere (a Fibonacci lattice) that together send as much as an
// environment of radiance 1. Lambert's cosine sums to pi within 1e-3.
std::vector<scene::Light> furnace_lights() {
  constexpr int kLights = 4000;
  std::vector<scene::Light> lights;
  for (int i = 0; i < kLights; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kLights;
    const float ring = std::sqrt(1.0f - y * y);
    const double around = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    lights.push_back(test_support::make_sun({ring * std::cos(around), y, ring * std::sin(around)},
                                            glm::vec3(4.0f * kPi / kLights)));
  }
  return lights;
}
constexpr float kLattice = 2e-3f;

// The least and the greatest that a pixel shows of the scene, lit from all sides alike.
std::pair<float, float> range_in_furnace(const scene::Scene& scene) {
  const scene::Environment furnace = constant_environment(1.0f);
  const TraceResult result = trace_shot(scene, {.eye = {0.4, 0.9, 3.0},
                                                .environment = &furnace,
                                                .lights = furnace_lights(),
                                                .width = 8,
                                                .height = 8,
                                                .focal_length = 12});
  std::pair<float, float> range{10.0f, 0.0f};
  for (std::size_t i = 0; i < result.images->mixed.pixels().size(); ++i) {
    if (result.images->met_virtual.pixels()[i] == 0) continue;
    const glm::vec3& pixel = result.images->mixed.pixels()[i];
    range = {std::min(range.first, pixel.x), std::max(range.second, pixel.x)};
  }
  return range;
}

// What a white sheet does not let through it sends back: nothing is lost and nothing is added.
TEST(PartialTransmission, AWhiteSheetVanishesInAFurnace) {
  for (const float t : {0.0f, 0.3f, 1.0f}) {
    scene::Scene scene;
    scene::Material material = frosted(t, true);
    material.base_color = glm::vec4(1.0f);
    add_object(scene, make_quad(glm::vec3(0.0f), {1, 0, 0.2f}, {0, 1, 0}), material,
               scene::Role::Virtual);
    const auto [least, most] = range_in_furnace(scene);
    EXPECT_NEAR(least, 1.0f, kLattice) << t;
    EXPECT_NEAR(most, 1.0f, kLattice) << t;
  }
}

// Solid glass scatters within itself, where less light arrives: never more than 1, closed or open.
TEST(PartialTransmission, WhiteSolidsNeverExceedAFurnace) {
  const scene::Mesh ball = test_support::make_sphere(glm::vec3(0.0f), 0.8f, 12, 6);
  for (const scene::Mesh& mesh : {ball, with_holes(ball, 3), turned_inside_out(ball)}) {
    scene::Scene scene;
    scene::Material material = frosted(0.6f, false);
    material.base_color = glm::vec4(1.0f);
    add_object(scene, mesh, material, scene::Role::Virtual);
    const auto [least, most] = range_in_furnace(scene);
    EXPECT_LE(most, 1.0f + kLattice);
    EXPECT_GT(least, 0.5f);
  }
}

TEST(PartialTransmission, WhiteOpaqueSurfacesNeverExceedAFurnace) {
  for (const float metallic : {0.0f, 0.5f, 1.0f}) {
    for (const float roughness : {1.0f, 0.6f, 0.4f}) {
      scene::Scene scene;
      scene::Material material = test_support::make_diffuse(glm::vec3(1.0f), roughness);
      material.metallic = metallic;
      add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 0.8f, 12, 6), material,
                 scene::Role::Virtual);
      EXPECT_LE(range_in_furnace(scene).second, 1.0f + kLattice) << metallic << " " << roughness;
    }
  }
}

// Real glass that scatters is in both solutions alike: without anything virtual nothing changes.
TEST(PartialTransmission, RealGlassLeavesTheCameraImageAlone) {
  scene::Scene scene;
  add_object(scene, make_box({-0.3f, 0, -0.3f}, {0.3f, 0.5f, 0.3f}), frosted(0.6f, false),
             scene::Role::Real);
  add_object(scene, test_support::make_floor(-0.01f, 4.0f),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  common::ImageRgb8 camera_image(32, 24, common::Rgb8(90, 80, 70));
  const TraceResult result = trace_shot(scene, {.eye = {0.5, 1, 2},
                                                .lights = {test_support::make_sun({0.3f, 1, 0.2f})},
                                                .camera_image = &camera_image,
                                                .width = 32,
                                                .height = 24,
                                                .focal_length = 30});
  EXPECT_TRUE(result.layers.is_zero());
}

}  // namespace
}  // namespace amalgam::trace
