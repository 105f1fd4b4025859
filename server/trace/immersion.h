// What a diffuse surface within a medium gains by its own light: much of what it sends up to the
// medium's surface is reflected there, and falls on it again (Saunderson 1942).
//
// Straight shadow rays find no such light. As a series it is 1 + rho R + (rho R)^2 + ..., with rho
// the albedo and R the share of diffuse light that is reflected inside a plane interface to air.
// With it, a white floor under water stays white in a furnace.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scene/material.h"

namespace amalgam::trace {

// R = 1 - (1 - R_outside) / n^2, because L / n^2 is conserved both ways. R_outside is the mean of
// Schlick's formula over the hemisphere, F0 + (1 - F0) / 21.
inline float internal_diffuse_reflectance(float ior) {
  if (ior <= 1.0f) return 0.0f;
  const float f0 = scene::normal_reflectance(ior);
  return 1.0f - (1.0f - f0) * (20.0f / 21.0f) / (ior * ior);
}

inline glm::vec3 immersion_gain(const scene::PhongTerms& terms, float ior) {
  const glm::vec3 albedo = glm::min(terms.albedo + terms.specular, glm::vec3(1.0f));
  return 1.0f / (1.0f - internal_diffuse_reflectance(ior) * albedo);
}

}  // namespace amalgam::trace
