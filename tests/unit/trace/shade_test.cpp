#include "trace/shade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace amalgam::trace {
namespace {

SurfacePoint upward() {
  SurfacePoint point;
  point.geometric_normal = point.shading_normal = {0, 1, 0};
  return point;
}

TEST(Phong, LambertIsAlbedoTimesCosineOverPi) {
  scene::PhongTerms terms;
  terms.albedo = {0.2f, 0.4f, 0.8f};
  const glm::vec3 to_light = glm::normalize(glm::vec3(1, 1, 0));
  const glm::vec3 out = phong_contribution(terms, upward(), {0, 1, 0}, to_light, glm::vec3(3.0f));
  EXPECT_NEAR(out.y, 0.4f * 3.0f * std::sqrt(0.5f) / std::numbers::pi_v<float>, 1e-6f);
}

TEST(Phong, NothingFromBehindEitherNormal) {
  scene::PhongTerms terms;
  terms.albedo = glm::vec3(1.0f);
  SurfacePoint point = upward();
  point.shading_normal = glm::normalize(glm::vec3(1.0f, 0.2f, 0.0f));
  const glm::vec3 below =
      glm::normalize(glm::vec3(1.0f, -0.1f, 0.0f));  // seen by the shading normal only
  EXPECT_EQ(phong_contribution(terms, point, {0, 1, 0}, below, glm::vec3(1.0f)), glm::vec3(0.0f));
}

// The lobe gives back no more than it gets: integrated over all views, specular 1 reflects at
// most 1.
TEST(Phong, SpecularConservesEnergy) {
  scene::PhongTerms terms;
  terms.specular = glm::vec3(1.0f);
  for (const float exponent : {0.0f, 1.0f, 20.0f, 200.0f}) {
    terms.exponent = exponent;
    for (const float angle : {0.0f, 0.7f, 1.3f}) {
      const glm::vec3 to_light(std::sin(angle), std::cos(angle), 0.0f);
      const glm::vec3 irradiance(1.0f / std::cos(angle));
      double reflected = 0.0;
      constexpr int kSteps = 400;
      for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
          const double theta = (i + 0.5) / kSteps * std::numbers::pi / 2;
          const double phi = (j + 0.5) / kSteps * std::numbers::pi * 2;
          const glm::vec3 view(std::sin(theta) * std::cos(phi), std::cos(theta),
                               std::sin(theta) * std::sin(phi));
          reflected += double{phong_contribution(terms, upward(), view, to_light, irradiance).x} *
                       std::cos(theta) * std::sin(theta);
        }
      }
      reflected *= std::numbers::pi * std::numbers::pi / (kSteps * static_cast<double>(kSteps));
      EXPECT_LE(reflected, 1.001) << exponent << " " << angle;
      if (angle == 0.0f && exponent >= 20.0f) {
        EXPECT_GT(reflected, 0.9) << exponent;
      }
    }
  }
}

}  // namespace
}  // namespace amalgam::trace
