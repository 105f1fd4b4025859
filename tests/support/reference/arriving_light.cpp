#include "support/reference/arriving_light.h"

#include <cmath>

namespace amalgam::reference {
namespace {

// KHR_lights_punctual's recommended attenuation at the end of a light's range.
double range_window(double distance, double range) {
  if (range <= 0.0) return 1.0;
  return std::clamp(1.0 - std::pow(distance / range, 4.0), 0.0, 1.0);
}

// KHR_lights_punctual's cone: 1 inside the inner one, 0 outside the outer one.
double spot_cone(double cosine, double cos_inner, double cos_outer) {
  const double ramp = (cosine - cos_outer) / std::max(0.001, cos_inner - cos_outer);
  const double clamped = std::clamp(ramp, 0.0, 1.0);
  return clamped * clamped;
}

}  // namespace

ArrivingLight arriving_light(const scene::Light& light, const Vec3& point) {
  const Vec3 axis = glm::normalize(Vec3(light.to_light));
  if (light.kind == scene::Light::Kind::Directional) {
    return {axis, kInfinity, Color(light.intensity)};
  }
  constexpr double kNearest = 1e-6;  // metres; nearer, 1/d^2 would only show the model's end
  const Vec3 way = Vec3(light.position) - point;
  const double distance = std::max(kNearest, glm::length(way));
  ArrivingLight arrival;
  arrival.to_light = way / distance;
  arrival.distance = distance;
  arrival.irradiance = Color(light.intensity) / (distance * distance) *
                       range_window(distance, static_cast<double>(light.range));
  if (light.kind == scene::Light::Kind::Spot) {
    arrival.irradiance *=
        spot_cone(glm::dot(arrival.to_light, axis), static_cast<double>(light.cos_inner),
                  static_cast<double>(light.cos_outer));
  }
  return arrival;
}

}  // namespace amalgam::reference
