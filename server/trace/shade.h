// Phong shading of a diffuse surface (eq. 4.6) by one light: the same formula as
// shaders/phong.glsl.
#pragma once

#include <glm/vec3.hpp>

#include "scene/light/light.h"
#include "scene/material.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// Whether light from there falls on the outside of the surface, by its geometric and by its shading
// normal.
bool is_lit_from(const SurfacePoint& point, const glm::vec3& to_light);

// Radiance towards `view` that the light causes if nothing is in its way; 0 if it is behind the
// surface (is_lit_from). See scene/material.h for the terms.
glm::vec3 phong_contribution(const scene::PhongTerms& terms, const SurfacePoint& point,
                             const glm::vec3& view, const glm::vec3& to_light,
                             const glm::vec3& irradiance);

}  // namespace amalgam::trace
