#include "scene/light/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/light/env_lights.h"

namespace amalgam::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Environment constant_map() {
  return {common::ImageRgb32f(64, 32, glm::vec3(1.0f)), false};
}

TEST(Irradiance, OfAConstantMapIsPi) {
  for (const glm::vec3& normal :
       {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0.6f, 0, -0.8f)}) {
    EXPECT_NEAR(environment_irradiance(constant_map(), normal).y, kPi, 0.01f);
  }
}

// Of one row, whose texels all lie at the horizon: 4 pi, each texel by the cosine of its centre.
TEST(Irradiance, OfOneRowHasTheWholeSolidAngle) {
  const Environment row{common::ImageRgb32f(4, 1, glm::vec3(1.0f)), false};
  // Centres at longitudes of 45 degrees: two of four are seen, at a cosine of sqrt(1/2).
  EXPECT_NEAR(environment_irradiance(row, {0, 0, 1}).x, 2.0f * kPi * std::sqrt(0.5f), 1e-5f);
}

TEST(Irradiance, OfOneLightIsItsCosine) {
  Light light;
  light.to_light = {0, 1, 0};
  light.intensity = glm::vec3(2.0f);
  const std::vector<Light> lights{light};
  EXPECT_FLOAT_EQ(lights_irradiance(lights, {0, 1, 0}).x, 2.0f);
  EXPECT_FLOAT_EQ(lights_irradiance(lights, {0.8f, 0.6f, 0}).x, 1.2f);
  EXPECT_FLOAT_EQ(lights_irradiance(lights, {0, -1, 0}).x, 0.0f);
}

// More lights stand in better for the map; no lights at all are off by everything.
TEST(IrradianceError, FallsWithTheNumberOfLights) {
  const Environment map = constant_map();
  const auto error_of = [&](int count) {
    return irradiance_error(map, median_cut(map, count)).rms;
  };
  EXPECT_LT(error_of(64), error_of(16));
  EXPECT_LT(error_of(256), error_of(64));
  EXPECT_LT(error_of(256), 0.02);
  EXPECT_NEAR(irradiance_error(map, {}).rms, 1.0, 0.01);
}

TEST(IrradianceError, OfABlackMapIsNone) {
  EXPECT_EQ(irradiance_error({common::ImageRgb32f(8, 4), false}, {}).rms, 0.0);
}

}  // namespace
}  // namespace amalgam::scene
