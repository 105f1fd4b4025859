#include "trace/fresnel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace amalgam::trace {
namespace {

double pow5(double x) {
  return x * x * x * x * x;
}

double sin2_transmitted(double cos_incident, double eta_incident, double eta_transmitted) {
  const double eta = eta_incident / eta_transmitted;
  return eta * eta * std::max(0.0, 1.0 - cos_incident * cos_incident);
}

double schlick(double f0, double cosine) {
  return f0 + (1.0 - f0) * pow5(1.0 - std::clamp(cosine, 0.0, 1.0));
}

double normal_incidence(double eta_incident, double eta_transmitted) {
  const double ratio = (eta_incident - eta_transmitted) / (eta_incident + eta_transmitted);
  return ratio * ratio;
}

}  // namespace

double reflectance_schlick(double cos_incident, double eta_incident, double eta_transmitted) {
  if (eta_incident == eta_transmitted) return 0.0;
  const double sin2 = sin2_transmitted(cos_incident, eta_incident, eta_transmitted);
  if (sin2 >= 1.0) return 1.0;
  const double cosine = eta_incident > eta_transmitted ? std::sqrt(1.0 - sin2) : cos_incident;
  return schlick(normal_incidence(eta_incident, eta_transmitted), cosine);
}

double reflectance_exact(double cos_incident, double eta_incident, double eta_transmitted) {
  const double sin2 = sin2_transmitted(cos_incident, eta_incident, eta_transmitted);
  if (sin2 >= 1.0) return 1.0;
  const double cos_transmitted = std::sqrt(1.0 - sin2);
  const double a = eta_incident * cos_incident, b = eta_transmitted * cos_transmitted;
  const double c = eta_incident * cos_transmitted, d = eta_transmitted * cos_incident;
  if (a + b == 0.0 || c + d == 0.0) return 1.0;  // grazing between equal media
  const double perpendicular = (a - b) / (a + b), parallel = (d - c) / (d + c);
  return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

double reflectance(FresnelModel model, double cos_incident, double eta_incident,
                   double eta_transmitted) {
  return model == FresnelModel::Exact
             ? reflectance_exact(cos_incident, eta_incident, eta_transmitted)
             : reflectance_schlick(cos_incident, eta_incident, eta_transmitted);
}

glm::vec3 reflectance_conductor(const glm::vec3& f0, float cos_incident) {
  const auto grazing = static_cast<float>(pow5(1.0 - std::clamp(double{cos_incident}, 0.0, 1.0)));
  return f0 + (glm::vec3(1.0f) - f0) * grazing;
}

double thin_sheet_reflectance(double surface_reflectance) {
  return 2.0 * surface_reflectance / (1.0 + surface_reflectance);
}

float shadow_transmittance(float cos_incident, float ior, bool thin) {
  if (ior == 1.0f) return 1.0f;
  const double surface = schlick(normal_incidence(1.0, double{ior}), double{cos_incident});
  return static_cast<float>(1.0 - (thin ? thin_sheet_reflectance(surface) : surface));
}

std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal,
                                  double eta_incident, double eta_transmitted) {
  const double cos_incident = std::clamp(-glm::dot(direction, normal), 0.0, 1.0);
  const double sin2 = sin2_transmitted(cos_incident, eta_incident, eta_transmitted);
  if (sin2 >= 1.0) return std::nullopt;
  const double eta = eta_incident / eta_transmitted;
  const double cos_transmitted = std::sqrt(std::max(0.0, 1.0 - sin2));
  return glm::normalize(eta * direction + (eta * cos_incident - cos_transmitted) * normal);
}

glm::dvec3 reflect(const glm::dvec3& direction, const glm::dvec3& normal) {
  return direction - 2.0 * glm::dot(direction, normal) * normal;
}

}  // namespace amalgam::trace
