// An air bubble in a ball of glass, in both usual modellings: a mesh of index 1 that faces
// outwards, or a cavity of the glass itself that faces inwards.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "unit/trace/glass_meshes.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_glass;
using test_support::make_sphere;

constexpr double kBall = 1.0, kBubble = 0.5, kIndex = 1.5;

enum class Bubble { OfAir, Cavity };

scene::Scene ball_with(Bubble bubble, int slices) {
  scene::Scene scene;
  const auto sphere = [&](double radius) {
    return make_sphere(glm::vec3(0.0f), static_cast<float>(radius), slices, slices / 2);
  };
  add_object(scene, sphere(kBall), make_glass(kIndex), scene::Role::Virtual);
  if (bubble == Bubble::OfAir) {
    add_object(scene, sphere(kBubble), make_glass(1.0f), scene::Role::Virtual);
  } else {
    add_to_last_material(scene, turned_inside_out(sphere(kBubble)));
  }
  return scene;
}

// A lamp 2 mm wide and 3 m away, where a ray of height b goes that was turned by so much (radians).
void add_target(scene::Scene& scene, double b, double turned) {
  const glm::dvec3 out(-std::sin(turned), 0.0, -std::cos(turned));
  const glm::dvec3 across(std::cos(turned), 0.0, -std::sin(turned));
  constexpr float kHalf = 1e-3f;
  add_object(scene,
             test_support::make_quad(glm::vec3(b * across + 3.0 * out), kHalf * glm::vec3(across),
                                     {0, kHalf, 0}),
             emitter(1.0f), scene::Role::Virtual);
}

class AirBubble : public testing::TestWithParam<Bubble> {};

// A ray at height b keeps n r sin(angle) = b at every radius r (Bouguer), so it leaves at height b
// again and turned by 2 ((i1 - r1) + (i2 - r2)). The facets' sagitta is 2e-5.
TEST_P(AirBubble, BendsRaysBySnell) {
  const TraceSettings settings{
      .max_depth = 4, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};
  for (const double b : {0.0, 0.1, 0.3}) {
    const double i1 = std::asin(b / kBall), r1 = std::asin(b / (kIndex * kBall));
    const double i2 = std::asin(b / (kIndex * kBubble)), r2 = std::asin(b / kBubble);
    const double turned = 2.0 * ((i1 - r1) + (i2 - r2));
    scene::Scene scene = ball_with(GetParam(), 512);
    add_target(scene, b, turned);
    const double outer = 1.0 - reflectance_exact(std::cos(i1), 1.0, kIndex);
    const double inner = 1.0 - reflectance_exact(std::cos(i2), kIndex, 1.0);
    EXPECT_NEAR(trace_ray(scene, {b, 1e-4, 3.0}, {b, 1e-4, 0.0}, settings).x,
                outer * outer * inner * inner, 2e-4)
        << b;
  }
}

// Past the critical angle, b > 0.5, the bubble reflects all: the ray goes round it as round a
// mirror.
TEST_P(AirBubble, ReflectsAllBeyondTheCriticalAngle) {
  const double b = 0.6;
  const double i1 = std::asin(b / kBall), r1 = std::asin(b / (kIndex * kBall));
  const double i2 = std::asin(b / (kIndex * kBubble));
  const double turned = 2.0 * (i1 - r1) - (std::numbers::pi - 2.0 * i2);
  scene::Scene scene = ball_with(GetParam(), 512);
  add_target(scene, b, turned);
  const TraceSettings settings{
      .max_depth = 3, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};
  const double outer = 1.0 - reflectance_exact(std::cos(i1), 1.0, kIndex);
  EXPECT_NEAR(trace_ray(scene, {b, 1e-4, 3.0}, {b, 1e-4, 0.0}, settings).x, outer * outer, 2e-4);
}

INSTANTIATE_TEST_SUITE_P(InGlass, AirBubble, testing::Values(Bubble::OfAir, Bubble::Cavity),
                         [](const auto& info) {
                           return info.param == Bubble::OfAir ? "OfAir" : "Cavity";
                         });

TEST(AirBubbleModellings, GiveTheSamePicture) {
  scene::Environment gradient{common::ImageRgb32f(16, 8)};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) gradient.radiance.at(x, y) = {0.05 * std::abs(x - 8), 0.1 * y, 1};
  }
  const auto picture = [&](Bubble bubble) {
    return trace_shot(ball_with(bubble, 64), {.eye = {0.3, 0.7, 3.0},
                                              .environment = &gradient,
                                              .width = 64,
                                              .height = 64,
                                              .focal_length = 70});
  };
  const TraceResult of_air = picture(Bubble::OfAir), cavity = picture(Bubble::Cavity);
  float worst = 0.0f;
  for (std::size_t i = 0; i < of_air.images->mixed.pixels().size(); ++i) {
    const glm::vec3 difference =
        of_air.images->mixed.pixels()[i] - cavity.images->mixed.pixels()[i];
    worst = std::max(worst, glm::length(difference));
  }
  EXPECT_LT(worst, 1e-4f);
  EXPECT_GT(of_air.counts.rays.refraction, 64u * 64u);
}

}  // namespace
}  // namespace amalgam::trace
