#include "support/reference/phong.h"

#include <cmath>

namespace amalgam::reference {

Phong phong_of(const Color& base_color, double metallic, double roughness) {
  constexpr double kDielectricReflectance = 0.04;
  const double alpha = roughness * roughness;
  Phong phong;
  phong.specular = glm::mix(Color(kDielectricReflectance), base_color, metallic);
  phong.albedo = base_color * (1.0 - metallic) * (1.0 - kDielectricReflectance);
  phong.exponent = alpha > 0.0 ? std::clamp(0.5 / (alpha * alpha) - 0.5, 0.0, 1024.0) : 1024.0;
  return phong;
}

Phong lambertian(const Color& base_color) {
  return {.albedo = base_color};
}

Color reflected(const Phong& phong, const Vec3& normal, const Vec3& to_light,
                const Vec3& to_viewer) {
  const double cosine = glm::dot(normal, to_light);
  const Vec3 mirrored = 2.0 * cosine * normal - to_light;
  const double lobe = std::pow(std::max(0.0, glm::dot(mirrored, to_viewer)), phong.exponent);
  return cosine *
         (phong.albedo / kPi + phong.specular * ((phong.exponent + 2.0) / (2.0 * kPi)) * lobe);
}

}  // namespace amalgam::reference
