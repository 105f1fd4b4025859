#include "trace/shade.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace amalgam::trace {

bool is_lit_from(const SurfacePoint& point, const glm::vec3& to_light) {
  return glm::dot(glm::vec3(point.shading_normal), to_light) > 0.0f &&
         glm::dot(point.geometric_normal, glm::dvec3(to_light)) > 0.0;
}

glm::vec3 phong_contribution(const scene::PhongTerms& terms, const SurfacePoint& point,
                             const glm::vec3& view, const glm::vec3& to_light,
                             const glm::vec3& irradiance) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const glm::vec3 normal(point.shading_normal);
  if (!is_lit_from(point, to_light)) return glm::vec3(0.0f);
  const float cosine = glm::dot(normal, to_light);
  const glm::vec3 reflected = 2.0f * cosine * normal - to_light;
  const float lobe = std::pow(std::max(glm::dot(reflected, view), 0.0f), terms.exponent);
  const glm::vec3 brdf =
      terms.albedo / kPi + terms.specular * ((terms.exponent + 2.0f) / (2.0f * kPi) * lobe);
  return irradiance * cosine * brdf;
}

}  // namespace amalgam::trace
