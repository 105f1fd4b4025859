// numerics B16, B17 and B19: radiance and exposure over all floats.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "scene/gltf/sanitize.h"
#include "scene/light/tone_map.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// What is in a hostile file: in a mirror ball nothing of it shows that is not finite.
TEST(RadianceRange, HostileEnvironmentsAreFiniteOnceLoaded) {
  scene::Environment environment = constant_environment(1.0f);
  const float hostile[] = {kInfinity, std::numeric_limits<float>::quiet_NaN(), -1.0f, 1e38f,
                           1e-40f};
  for (std::size_t i = 0; i < environment.radiance.pixels().size(); ++i) {
    environment.radiance.pixels()[i] = glm::vec3(hostile[i % std::size(hostile)]);
  }
  scene::Scene ball;
  add_object(ball, test_support::make_sphere(glm::vec3(0.0f), 0.5f), test_support::make_mirror(),
             scene::Role::Virtual);
  const Shot shot{.environment = &environment, .width = 32, .height = 32, .focal_length = 60};
  // Beyond: as it is in the file, it would be replaced by black and counted.
  EXPECT_GT(trace_shot(ball, shot).nonfinite, 100u);
  // 32 texels of three channels, of which every fifth is denormal and fine.
  EXPECT_EQ(scene::sanitize_radiance(environment.radiance).total(), 3u * (32u - 6u));
  const TraceResult sanitised = trace_shot(ball, shot);
  EXPECT_EQ(sanitised.nonfinite, 0u);
  for (const glm::vec3& pixel : sanitised.images->mixed.pixels()) {
    EXPECT_TRUE(pixel.x >= 0.0f && pixel.x <= 65504.0f) << pixel.x;
  }
}

// Two lamps of the largest radiance behind each other add up to more than the largest float.
TEST(RadianceRange, SumsBeyondTheLargestFloatAreCounted) {
  const auto nonfinite = [](float radiance) {
    scene::Scene scene;
    scene::Material pane = test_support::make_glass();
    pane.thin = true;
    pane.emission = glm::vec3(radiance);
    for (const float z : {0.0f, 0.5f}) {
      add_object(scene, test_support::make_quad({0, 0, z}, {1, 0, 0}, {0, 1, 0}), pane,
                 scene::Role::Virtual);
    }
    return trace_shot(scene, {.width = 1, .height = 1}).nonfinite;
  };
  for (const float radiance : {1.0f, 1e20f, 1e38f}) EXPECT_EQ(nonfinite(radiance), 0u) << radiance;
  EXPECT_EQ(nonfinite(3e38f), 1u);
}

// Every 1009th float, denormal ones too, against the formula in double.
TEST(RadianceRange, ToneMappingKeepsItsDigitsForEveryFloat) {
  float before = 0.0f;
  const auto last = std::bit_cast<std::uint32_t>(kInfinity);
  for (std::uint32_t bits = 1; bits < last; bits += 1009) {
    const auto x = std::bit_cast<float>(bits);
    const double exact = double{x} / (1.0 + double{x});
    const float compressed = scene::compress(x);
    ASSERT_NEAR(compressed, exact, 1.2e-7 * exact + 1e-45) << x;
    ASSERT_GE(compressed, before) << x;
    ASSERT_LE(compressed, 1.0f);
    before = compressed;
  }
  // Beyond: light that is less than nothing, or not a number, is black.
  EXPECT_EQ(scene::compress(kInfinity), 1.0f);
}

// Real surfaces alone make no difference, at any exposure and under any lamp.
TEST(RadianceRange, NothingVirtualMakesNoDifferenceAtAnyBrightness) {
  const scene::Environment environment = constant_environment(0.5f);
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 5.0f),
             test_support::make_diffuse(glm::vec3(0.4f), 0.3f), scene::Role::Real);
  add_object(scene, test_support::make_box({-0.2f, 0, -0.2f}, {0.2f, 0.4f, 0.2f}),
             test_support::make_glass(), scene::Role::Real);
  for (const float brightness : {1e-40f, 1e-10f, 1.0f, 1e10f, 3e38f}) {
    for (const float exposure : {1e-6f, 1.0f, 1e6f, 1e30f}) {
      const TraceResult result = trace_shot(
          scene, {.eye = {0.5, 1, 2},
                  .environment = &environment,
                  .lights = {test_support::make_sun({0.3f, 1, 0.2f}, glm::vec3(brightness))},
                  .width = 24,
                  .height = 24,
                  .focal_length = 30,
                  .exposure = exposure});
      EXPECT_TRUE(result.layers.is_zero()) << brightness << " at " << exposure;
    }
  }
}

}  // namespace
}  // namespace amalgam::trace
