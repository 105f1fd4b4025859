#include "scene/light/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/gltf/environment_loader.h"
#include "support/test_data.h"

namespace amalgam::scene {
namespace {

Environment blank(int width, int height) {
  Environment environment;
  environment.radiance = common::ImageRgb32f(width, height);
  return environment;
}

TEST(Environment, AxesLieWhereOpenExrPutsThem) {
  const Environment environment = blank(256, 128);
  const auto pixel = [&](const glm::vec3& d) { return environment_pixel(environment, d); };
  EXPECT_NEAR(pixel({0, 0, 1}).x, 127.5f, 1e-3f);   // centre +Z
  EXPECT_NEAR(pixel({1, 0, 0}).x, 63.5f, 1e-3f);    // left quarter +X
  EXPECT_NEAR(pixel({-1, 0, 0}).x, 191.5f, 1e-3f);  // right quarter -X
  EXPECT_NEAR(pixel({0, 0, 1}).y, 63.5f, 1e-3f);
  EXPECT_NEAR(pixel({0, 1, 0}).y, -0.5f, 1e-3f);  // top +Y
  EXPECT_NEAR(pixel({0, -1, 0}).y, 127.5f, 1e-3f);
}

TEST(Environment, DirectionAndPixelAreInverse) {
  const Environment environment = blank(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const glm::vec3 d = environment_direction(environment, glm::vec2(x, y));
      EXPECT_NEAR(glm::length(d), 1.0f, 1e-5f);
      const glm::vec2 back = environment_pixel(environment, d);
      EXPECT_NEAR(back.x, static_cast<float>(x), 1e-3f);
      EXPECT_NEAR(back.y, static_cast<float>(y), 1e-3f);
    }
  }
}

TEST(Environment, TexelsCoverTheSphere) {
  for (const int height : {1, 2, 7, 64}) {
    const Environment environment = blank(2 * height, height);
    double sum = 0.0;
    for (int y = 0; y < height; ++y) sum += 2 * height * texel_solid_angle(environment, y);
    EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 1e-12) << height;
  }
  // Between the pole and 60 degrees of latitude: 2 pi (1 - sin 60), in 12 texels.
  EXPECT_NEAR(texel_solid_angle(blank(12, 6), 0), std::numbers::pi / 6 * (1 - std::sqrt(0.75)),
              1e-12);
}

TEST(Environment, LookUpIsBilinearAndWrapsAround) {
  Environment environment = blank(4, 2);
  environment.radiance.at(0, 0) = environment.radiance.at(0, 1) = glm::vec3(1.0f);
  // Between the last and the first column, at longitude 180 degrees: half of each.
  EXPECT_NEAR(sample_environment(environment, {0, 0, -1}).x, 0.5f, 1e-5f);
  EXPECT_NEAR(sample_environment(environment, environment_direction(environment, {0, 0})).x, 1.0f,
              1e-5f);
  EXPECT_NEAR(sample_environment(environment, environment_direction(environment, {2, 1})).x, 0.0f,
              1e-5f);
}

TEST(Environment, EveryDirectionFindsAFiniteTexel) {
  Environment environment = blank(7, 3);
  for (glm::vec3& texel : environment.radiance.pixels()) texel = glm::vec3(2.0f);
  constexpr float kPi = std::numbers::pi_v<float>;
  for (float a = -kPi; a <= kPi; a += 0.05f) {
    for (float b = 0.0f; b <= kPi; b += 0.05f) {
      const glm::vec3 d(std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a));
      EXPECT_NEAR(sample_environment(environment, d).x, 2.0f, 1e-5f);
    }
  }
  EXPECT_NEAR(sample_environment(environment, {0, 1.0000001f, 0}).x, 2.0f, 1e-5f);
}

// The picture has the axes painted into it: around +Z, dark lines run towards +X and +Y.
TEST(Environment, LabelsOfTheOrientationPictureAreFoundWhereTheySay) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  std::vector<std::string> notes;
  const Environment environment =
      load_environment(*data / "envmaps" / "openexr-images" / "OrientationLatLong.exr", notes);
  const auto mean_along = [&](const glm::vec3& from, const glm::vec3& to) {
    float sum = 0.0f;
    for (int i = 0; i <= 10; ++i) {
      const glm::vec3 d = glm::normalize(glm::mix(from, to, 0.05f + 0.02f * static_cast<float>(i)));
      sum += sample_environment(environment, d).y;
    }
    return sum / 11.0f;
  };
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_LT(mean_along(z, x), 0.3f);
  EXPECT_GT(mean_along(z, -x), 0.5f);
  EXPECT_LT(mean_along(z, y), 0.3f);
  EXPECT_GT(mean_along(z, -y), 0.5f);
  EXPECT_LT(mean_along(x, z), 0.3f);
  EXPECT_LT(mean_along(-x, z), 0.3f);
}

}  // namespace
}  // namespace amalgam::scene
