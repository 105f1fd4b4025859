#include "support/reference/fresnel.h"

#include <cmath>

namespace amalgam::reference {

double normal_reflectance(double n1, double n2) {
  const double amplitude = (n2 - n1) / (n2 + n1);
  return amplitude * amplitude;
}

double schlick(double normal_reflectance, double cosine) {
  return normal_reflectance + (1.0 - normal_reflectance) * std::pow(1.0 - cosine, 5.0);
}

Color schlick(const Color& normal_reflectance, double cosine) {
  return normal_reflectance + (1.0 - normal_reflectance) * std::pow(1.0 - cosine, 5.0);
}

std::optional<double> transmitted_cosine(double n1, double n2, double cos_incident) {
  const double ratio = n1 / n2;
  const double sin2 = ratio * ratio * std::max(0.0, 1.0 - cos_incident * cos_incident);
  if (sin2 >= 1.0) return std::nullopt;
  return std::sqrt(1.0 - sin2);
}

double exact_reflectance(double n1, double n2, double cos_incident) {
  const auto cos_transmitted = transmitted_cosine(n1, n2, cos_incident);
  if (!cos_transmitted) return 1.0;
  const double s =
      (n1 * cos_incident - n2 * *cos_transmitted) / (n1 * cos_incident + n2 * *cos_transmitted);
  const double p =
      (n2 * cos_incident - n1 * *cos_transmitted) / (n2 * cos_incident + n1 * *cos_transmitted);
  return 0.5 * (s * s + p * p);
}

double reflectance(Fresnel model, double n1, double n2, double cos_incident) {
  if (n1 == n2) return 0.0;  // no interface, though Schlick's curve has a grazing end even there
  if (model == Fresnel::Exact) return exact_reflectance(n1, n2, cos_incident);
  const auto cos_transmitted = transmitted_cosine(n1, n2, cos_incident);
  if (!cos_transmitted) return 1.0;
  return schlick(normal_reflectance(n1, n2), n1 <= n2 ? cos_incident : *cos_transmitted);
}

double thin_reflectance(double reflectance) {
  return 2.0 * reflectance / (1.0 + reflectance);
}

std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double n1, double n2) {
  const double cos_incident = std::min(1.0, -glm::dot(direction, normal));
  const auto cos_transmitted = transmitted_cosine(n1, n2, cos_incident);
  if (!cos_transmitted) return std::nullopt;
  const double ratio = n1 / n2;
  return glm::normalize(ratio * direction + (ratio * cos_incident - *cos_transmitted) * normal);
}

Vec3 reflect(const Vec3& direction, const Vec3& normal) {
  return glm::normalize(direction - 2.0 * glm::dot(direction, normal) * normal);
}

}  // namespace amalgam::reference
