#include "scene/light/irradiance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "scene/light/luminance.h"

namespace amalgam::scene {
namespace {

constexpr double kPi = std::numbers::pi;

struct Texel {
  glm::dvec3 direction{0.0};
  glm::dvec3 energy{0.0};  // radiance x solid angle
};

std::vector<Texel> texels(const Environment& environment) {
  const common::ImageRgb32f& map = environment.radiance;
  std::vector<Texel> all;
  all.reserve(map.pixels().size());
  for (int y = 0; y < map.height(); ++y) {
    const double solid_angle = texel_solid_angle(environment, y);
    for (int x = 0; x < map.width(); ++x) {
      all.push_back({glm::dvec3(environment_direction(environment, {x, y})),
                     glm::dvec3(map.at(x, y)) * solid_angle});
    }
  }
  return all;
}

glm::dvec3 irradiance(std::span<const Texel> all, const glm::dvec3& normal) {
  glm::dvec3 sum(0.0);
  for (const Texel& texel : all)
    sum += texel.energy * std::max(0.0, glm::dot(normal, texel.direction));
  return sum;
}

// The k-th of n directions on a Fibonacci spiral: as even as n points on a sphere easily are.
glm::dvec3 spread_direction(int k, int n) {
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  const double y = 1.0 - 2.0 * (k + 0.5) / n;
  const double r = std::sqrt(1.0 - y * y);
  return {r * std::cos(golden_angle * k), y, r * std::sin(golden_angle * k)};
}

}  // namespace

glm::vec3 environment_irradiance(const Environment& environment, const glm::vec3& normal) {
  return glm::vec3(irradiance(texels(environment), glm::dvec3(normal)));
}

glm::vec3 lights_irradiance(std::span<const Light> lights, const glm::vec3& normal) {
  glm::vec3 sum(0.0f);
  for (const Light& light : lights)
    sum += light.intensity * std::max(0.0f, glm::dot(normal, light.to_light));
  return sum;
}

IrradianceError irradiance_error(const Environment& environment, std::span<const Light> lights,
                                 int normals) {
  const std::vector<Texel> all = texels(environment);
  double squares = 0.0, worst = 0.0, mean = 0.0;
  for (int k = 0; k < normals; ++k) {
    const glm::dvec3 normal = spread_direction(k, normals);
    const double exact = luminance(irradiance(all, normal));
    const double error =
        luminance(glm::dvec3(lights_irradiance(lights, glm::vec3(normal)))) - exact;
    squares += error * error;
    worst = std::max(worst, std::abs(error));
    mean += exact;
  }
  mean /= normals;
  if (!(mean > 0.0)) return {};
  return {std::sqrt(squares / normals) / mean, worst / mean};
}

}  // namespace amalgam::scene
