// Measures how well a few lights approximate an environment map, by the irradiance on a diffuse
// surface.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "scene/light/environment.h"
#include "scene/light/light.h"

namespace amalgam::scene {

// Irradiance on a surface with this unit normal: integral of L max(N.w, 0) dw over the map's
// texels, each at its centre, and its sum over directional lights.
glm::vec3 environment_irradiance(const Environment& environment, const glm::vec3& normal);
glm::vec3 lights_irradiance(std::span<const Light> lights, const glm::vec3& normal);

struct IrradianceError {
  // Of luminance over normals spread evenly on the sphere, relative to the map's mean irradiance.
  double rms = 0.0;
  double maximum = 0.0;  // likewise
};

// normals: their number. Integrates the map for each, so this is for tools and not for frames.
IrradianceError irradiance_error(const Environment& environment, std::span<const Light> lights,
                                 int normals = 256);

}  // namespace amalgam::scene
