#include "scene/light/env_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "scene/gltf/environment_loader.h"
#include "support/test_data.h"

namespace amalgam::scene {
namespace {

Light from(const glm::vec3& direction, const glm::vec3& intensity = glm::vec3(1.0f)) {
  Light light;
  light.to_light = glm::normalize(direction);
  light.intensity = intensity;
  return light;
}

Environment constant(int width, int height, const glm::vec3& radiance) {
  Environment environment;
  environment.radiance = common::ImageRgb32f(width, height, radiance);
  return environment;
}

Environment varied() {
  Environment environment = constant(96, 48, glm::vec3(0.1f, 0.2f, 0.3f));
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 96; ++x) {
      environment.radiance.at(x, y) += glm::vec3((x * 7 + y * 13) % 11, (x * 3 + y) % 5, y % 3);
    }
  }
  environment.radiance.at(20, 10) = glm::vec3(30000.0f, 20000.0f, 10000.0f);
  return environment;
}

glm::dvec3 total(std::span<const Light> lights) {
  glm::dvec3 sum(0.0);
  for (const Light& light : lights) sum += glm::dvec3(light.intensity);
  return sum;
}

glm::dvec3 energy_of(const Environment& environment) {
  glm::dvec3 sum(0.0);
  const int width = environment.radiance.width(), height = environment.radiance.height();
  constexpr double kPi = std::numbers::pi;
  for (int y = 0; y < height; ++y) {
    const double band = std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height);
    for (int x = 0; x < width; ++x) {
      sum += glm::dvec3(environment.radiance.at(x, y)) * (2.0 * kPi / width * band);
    }
  }
  return sum;
}

void expect_relative(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i] / expected[i], 1.0, tolerance) << i;
}

// Irradiance on a white Lambert surface over pi: its radiance under light of radiance 1.
double lambert(std::span<const Light> lights, const glm::vec3& normal) {
  double sum = 0.0;
  for (const Light& light : lights) {
    sum += static_cast<double>(light.intensity.x) *
           std::max(0.0, static_cast<double>(glm::dot(light.to_light, normal)));
  }
  return sum / std::numbers::pi;
}

// numerics B20: in the thesis these two fall into one sector and cancel.
TEST(EnvLights, UpAndDownMakeTwoLights) {
  const Light lights[] = {from({0, 1, 0}), from({0, -1, 0})};
  const auto binned = bin_into_octants(lights);
  ASSERT_EQ(binned.size(), 2u);
  EXPECT_EQ(binned[0].to_light, -binned[1].to_light);
}

TEST(EnvLights, ADarkSectorGivesNoLight) {
  std::vector<Light> lights;
  for (const float x : {-1.0f, 1.0f}) {
    for (const float y : {-1.0f, 1.0f}) {
      for (const float z : {-1.0f, 1.0f}) lights.push_back(from({x, y, z}));
    }
  }
  EXPECT_EQ(bin_into_octants(lights).size(), 8u);
  lights[3].intensity = glm::vec3(0.0f);
  const auto binned = bin_into_octants(lights);
  EXPECT_EQ(binned.size(), 7u);
  for (const Light& light : binned) EXPECT_NEAR(glm::length(light.to_light), 1.0f, 1e-6f);
}

TEST(EnvLights, NegligibleSectorsAreDropped) {
  const Light lights[] = {from({1, 1, 1}), from({-1, 1, 1}, glm::vec3(0.9e-6f)),
                          from({-1, 1, -1}, glm::vec3(2e-6f))};
  EXPECT_EQ(bin_into_octants(lights).size(), 2u);
}

TEST(EnvLights, DarkLightsPullLess) {
  const Light lights[] = {from({1, 1, 1}, glm::vec3(1.0f)),
                          from({1, 0.1f, 0.1f}, glm::vec3(0.01f))};
  const auto binned = bin_into_octants(lights);
  ASSERT_EQ(binned.size(), 1u);
  EXPECT_GT(glm::dot(binned[0].to_light, glm::normalize(glm::vec3(1.0f))), 0.9999f);
}

TEST(EnvLights, ColorsSumToTheMaps) {
  const Environment environment = varied();
  const glm::dvec3 expected = energy_of(environment);
  for (const char* text :
       {"sectors", "median-cut:1", "median-cut:7", "median-cut:128", "median-cut:1000"}) {
    const auto lights = extract_lights(environment, parse_env_light_options(text));
    expect_relative(total(lights), expected, 1e-5);
  }
}

TEST(EnvLights, MedianCutGivesTheNumberAskedForAndSimilarEnergies) {
  const Environment environment = constant(128, 64, glm::vec3(1.0f));
  for (const int count : {1, 2, 3, 8, 128, 200}) {
    const auto lights = median_cut(environment, count);
    EXPECT_EQ(static_cast<int>(lights.size()), count);
    EXPECT_LT(lights.front().intensity.x, 4.0f * lights.back().intensity.x);
  }
}

// Regions are cut across their longer side on the sphere. Sixteen regions of equal energy are four
// by four: those that touch a pole are higher than wide, although on the map they are square.
TEST(EnvLights, MedianCutMeasuresRegionsOnTheSphere) {
  const auto lights = median_cut(constant(128, 64, glm::vec3(1.0f)), 16);
  ASSERT_EQ(lights.size(), 16u);
  // Of a quarter of the band between the heights 1/2 and 1 the centroid is (h, 3/4, h), h being
  // (pi/3 - sqrt(3)/4) 2/pi; of the one between 0 and 1/2 it is (h, 1/4, h), h being
  // (pi/6 + sqrt(3)/4) 2/pi.
  constexpr double kPi = std::numbers::pi;
  const double wide = std::sqrt(3.0) / 4.0;
  const auto height = [](double y, double h) { return y / std::sqrt(y * y + 2.0 * h * h); };
  const double high = height(0.75, (kPi / 3.0 - wide) * 2.0 / kPi);
  const double low = height(0.25, (kPi / 6.0 + wide) * 2.0 / kPi);
  const auto count_near = [&](double expected) {
    return std::count_if(lights.begin(), lights.end(), [&](const Light& light) {
      return std::abs(light.to_light.y - expected) < 0.03;  // cuts are at whole texels
    });
  };
  for (const double expected : {high, low, -low, -high}) EXPECT_EQ(count_near(expected), 4);
}

TEST(EnvLights, ASunIsFoundWhereItStands) {
  Environment environment = constant(128, 64, glm::vec3(0.0f));
  environment.radiance.at(90, 12) = glm::vec3(1000.0f);
  for (const char* text : {"sectors", "median-cut:16"}) {
    const auto lights = extract_lights(environment, parse_env_light_options(text));
    ASSERT_EQ(lights.size(), 1u) << text;
    const glm::vec3 expected = environment_direction(environment, {90, 12});
    EXPECT_GT(glm::dot(lights[0].to_light, expected), 0.999999f) << text;
  }
}

TEST(EnvLights, BlackAndEmptyMapsGiveNoLights) {
  EXPECT_TRUE(extract_lights(constant(16, 8, glm::vec3(0.0f)), {}).empty());
  EXPECT_TRUE(extract_lights(Environment(), {}).empty());
  EXPECT_EQ(extract_lights(constant(1, 1, glm::vec3(1.0f)), {}).size(), 1u);
}

// numerics B20: a white Lambert surface in constant light goes to 1 as the number of lights grows.
TEST(EnvLights, ConstantEnvironmentOnWhiteLambertGoesToOne) {
  const Environment environment = constant(256, 128, glm::vec3(1.0f));
  const glm::vec3 normals[] = {{0, 1, 0},
                               {0, -1, 0},
                               glm::normalize(glm::vec3(1, 2, 3)),
                               glm::normalize(glm::vec3(-3, 0.2f, 1))};
  double before = 1.0;
  for (const auto& [count, tolerance] :
       {std::pair(16, 0.12), std::pair(64, 0.03), std::pair(256, 0.012), std::pair(1024, 0.003),
        std::pair(4096, 0.001)}) {
    const auto lights = median_cut(environment, count);
    double worst = 0.0;
    for (const glm::vec3& normal : normals)
      worst = std::fmax(worst, std::abs(lambert(lights, normal) - 1.0));
    EXPECT_LT(worst, tolerance) << count;
    EXPECT_LT(worst, before) << count;
    before = worst;
  }
  // Eight octants are coarse: the error of their directions, (2 / sqrt 3) - 1 on a surface along an
  // axis.
  EXPECT_NEAR(lambert(extract_lights(environment, {}), {0, 1, 0}), 2.0 / std::sqrt(3.0), 0.01);
}

TEST(EnvLights, OptionsAreParsed) {
  EXPECT_EQ(parse_env_light_options("sectors"), EnvLightOptions{});
  const EnvLightOptions options = parse_env_light_options("median-cut:512");
  EXPECT_EQ(options.method, EnvLightOptions::Method::MedianCut);
  EXPECT_EQ(options.median_cut, 512);
  EXPECT_EQ(to_string(options), "median-cut:512");
  EXPECT_EQ(to_string(EnvLightOptions{}), "sectors");
  for (const char* wrong :
       {"", "sector", "median-cut", "median-cut:", "median-cut:0", "median-cut:-3", "median-cut:8x",
        "median-cut:99999999999", "median-cut:5000"}) {
    EXPECT_THROW(parse_env_light_options(wrong), std::invalid_argument) << wrong;
  }
}

TEST(EnvLights, RealMapsKeepTheirEnergy) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*data / "envmaps" / "pmndrs")) {
    if (entry.path().extension() != ".exr") continue;
    std::vector<std::string> notes;
    const Environment environment = load_environment(entry.path(), notes);
    const auto lights = extract_lights(environment, {});
    EXPECT_LE(lights.size(), 8u);
    expect_relative(total(lights), energy_of(environment), 1e-5);
    ++count;
  }
  EXPECT_GE(count, 15);
}

}  // namespace
}  // namespace amalgam::scene
