#include "trace/shade.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace amalgam::trace {

glm::vec3 phong_contribution(const scene::PhongTerms& terms, const SurfacePoint& point,
                             const glm::vec3& view, const scene::LightArrival& arrival) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const glm::vec3 normal(point.shading_normal);
  const float cosine = glm::dot(normal, arrival.to_light);
  if (!(cosine > 0.0f) || !(glm::dot(point.geometric_normal, glm::dvec3(arrival.to_light)) > 0.0)) {
    return glm::vec3(0.0f);
  }
  const glm::vec3 reflected = 2.0f * cosine * normal - arrival.to_light;
  const float lobe = std::pow(std::max(glm::dot(reflected, view), 0.0f), terms.exponent);
  const glm::vec3 brdf =
      terms.albedo / kPi + terms.specular * ((terms.exponent + 2.0f) / (2.0f * kPi) * lobe);
  return arrival.irradiance * cosine * brdf;
}

}  // namespace amalgam::trace
