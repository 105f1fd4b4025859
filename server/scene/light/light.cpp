#include "scene/light/light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace amalgam::scene {

LightArrival light_arrival(const Light& light, const glm::vec3& point) {
  if (light.kind == Light::Kind::Directional) {
    return {light.to_light, std::numeric_limits<float>::infinity(), light.intensity};
  }
  const glm::vec3 offset = light.position - point;
  const float distance = glm::length(offset);
  const float d = std::max(distance, kMinLightDistance);
  const glm::vec3 to_light = offset / d;
  float window = 1.0f;
  if (light.range > 0.0f) {
    const float ratio = d / light.range;
    window = std::clamp(1.0f - ratio * ratio * ratio * ratio, 0.0f, 1.0f);
  }
  if (light.kind == Light::Kind::Spot) {
    const float scale = 1.0f / std::max(kMinConeWidth, light.cos_inner - light.cos_outer);
    const float cone =
        std::clamp((glm::dot(light.to_light, to_light) - light.cos_outer) * scale, 0.0f, 1.0f);
    window *= cone * cone;
  }
  return {to_light, distance, light.intensity * (window / (d * d))};
}

}  // namespace amalgam::scene
