#include "scene/light/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace amalgam::scene {

glm::vec2 environment_pixel(const Environment& environment, const glm::vec3& direction) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float longitude = std::atan2(direction.x, direction.z);  // 0 at +Z, pi/2 at +X
  const float colatitude = std::acos(std::clamp(direction.y, -1.0f, 1.0f));
  const float u = 0.5f - longitude / (2.0f * kPi);
  const float v = colatitude / kPi;
  return {u * static_cast<float>(environment.radiance.width()) - 0.5f,
          v * static_cast<float>(environment.radiance.height()) - 0.5f};
}

glm::vec3 environment_direction(const Environment& environment, const glm::vec2& pixel) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float u = (pixel.x + 0.5f) / static_cast<float>(environment.radiance.width());
  const float v = (pixel.y + 0.5f) / static_cast<float>(environment.radiance.height());
  const float longitude = (0.5f - u) * 2.0f * kPi, colatitude = v * kPi;
  return {std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
          std::sin(colatitude) * std::cos(longitude)};
}

double texel_solid_angle(const Environment& environment, int y) {
  constexpr double kPi = std::numbers::pi;
  const double height = environment.radiance.height();
  const double top = std::cos(kPi * y / height), bottom = std::cos(kPi * (y + 1) / height);
  return 2.0 * kPi / environment.radiance.width() * (top - bottom);
}

glm::vec3 largest_radiance(const Environment& environment) {
  glm::vec3 largest(0.0f);
  for (const glm::vec3& texel : environment.radiance.pixels()) largest = glm::max(largest, texel);
  return largest;
}

glm::vec3 sample_environment(const Environment& environment, const glm::vec3& direction) {
  const common::ImageRgb32f& map = environment.radiance;
  const glm::vec2 pixel = environment_pixel(environment, direction);
  const float floor_x = std::floor(pixel.x), floor_y = std::floor(pixel.y);
  const float fx = pixel.x - floor_x, fy = pixel.y - floor_y;
  const int width = map.width(), height = map.height();
  const int x0 = (static_cast<int>(floor_x) % width + width) % width;
  const int x1 = (x0 + 1) % width;
  const int y0 = std::clamp(static_cast<int>(floor_y), 0, height - 1);
  const int y1 = std::clamp(static_cast<int>(floor_y) + 1, 0, height - 1);
  return glm::mix(glm::mix(map.at(x0, y0), map.at(x1, y0), fx),
                  glm::mix(map.at(x0, y1), map.at(x1, y1), fx), fy);
}

}  // namespace amalgam::scene
