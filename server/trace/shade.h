// Phong shading of a diffuse surface (eq. 4.6) by one light: the same formula as
// shaders/phong.glsl.
#pragma once

#include <glm/vec3.hpp>

#include "scene/light/light.h"
#include "scene/material.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// Whether the light falls on the viewed side of the surface, by both the geometric and the shading
// normal.
bool is_lit_from(const SurfacePoint& point, const glm::vec3& to_light);

// Radiance towards `view` from an unoccluded light; 0 if the light is behind the surface
// (is_lit_from). See scene/material.h for the terms.
glm::vec3 phong_contribution(const scene::PhongTerms& terms, const SurfacePoint& point,
                             const glm::vec3& view, const glm::vec3& to_light,
                             const glm::vec3& irradiance);

}  // namespace amalgam::trace
