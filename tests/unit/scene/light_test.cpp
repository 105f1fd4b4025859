#include "scene/light/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace amalgam::scene {
namespace {

TEST(Light, DirectionalLightIsTheSameEverywhere) {
  Light light;
  light.to_light = {0, 0, 1};
  light.intensity = {1, 2, 3};
  for (const glm::vec3& point : {glm::vec3(0), glm::vec3(100, -5, 3)}) {
    const LightArrival arrival = light_arrival(light, point);
    EXPECT_EQ(arrival.to_light, light.to_light);
    EXPECT_EQ(arrival.irradiance, light.intensity);
    EXPECT_EQ(arrival.distance, std::numeric_limits<float>::infinity());
  }
}

TEST(Light, PointLightFallsWithTheSquare) {
  Light light;
  light.kind = Light::Kind::Point;
  light.position = {0, 3, 0};
  light.intensity = glm::vec3(9.0f);
  const LightArrival arrival = light_arrival(light, glm::vec3(0));
  EXPECT_FLOAT_EQ(arrival.distance, 3.0f);
  EXPECT_FLOAT_EQ(arrival.irradiance.x, 1.0f);
  EXPECT_EQ(arrival.to_light, glm::vec3(0, 1, 0));
}

TEST(Light, APointInsideTheLampStaysFinite) {
  Light light;
  light.kind = Light::Kind::Point;
  light.intensity = glm::vec3(1.0f);
  const LightArrival arrival = light_arrival(light, light.position);
  EXPECT_TRUE(std::isfinite(arrival.irradiance.x));
}

TEST(Light, RangeEndsTheLight) {
  Light light;
  light.kind = Light::Kind::Point;
  light.intensity = glm::vec3(1.0f);
  light.range = 2.0f;
  EXPECT_FLOAT_EQ(light_arrival(light, {1, 0, 0}).irradiance.x, 1.0f - 1.0f / 16.0f);
  EXPECT_EQ(light_arrival(light, {2, 0, 0}).irradiance.x, 0.0f);
  EXPECT_EQ(light_arrival(light, {3, 0, 0}).irradiance.x, 0.0f);
}

TEST(Light, SpotFadesBetweenItsCones) {
  Light light;
  light.kind = Light::Kind::Spot;
  light.to_light = {0, 1, 0};  // shines down
  light.position = {0, 1, 0};
  light.intensity = glm::vec3(1.0f);
  light.cos_inner = std::cos(0.3f);
  light.cos_outer = std::cos(0.6f);
  const auto at = [&](float angle) {
    const LightArrival arrival = light_arrival(light, {std::tan(angle), 0, 0});
    return arrival.irradiance.x * arrival.distance * arrival.distance;
  };
  EXPECT_FLOAT_EQ(at(0.0f), 1.0f);
  EXPECT_NEAR(at(0.29f), 1.0f, 1e-5f);
  EXPECT_GT(at(0.4f), at(0.5f));
  EXPECT_EQ(at(0.61f), 0.0f);
  EXPECT_EQ(light_arrival(light, {0, 2, 0}).irradiance.x, 0.0f);  // behind it
}

}  // namespace
}  // namespace amalgam::scene
