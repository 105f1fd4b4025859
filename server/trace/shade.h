// Phong shading of a diffuse surface (eq. 4.6) by one light: the same formula as
// shaders/phong.glsl.
#pragma once

#include <glm/vec3.hpp>

#include "scene/light.h"
#include "scene/material.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// Radiance towards `view` that the light causes if nothing is in its way; 0 if it is behind the
// surface, by its geometric or its shading normal. See scene/material.h for the terms.
glm::vec3 phong_contribution(const scene::PhongTerms& terms, const SurfacePoint& point,
                             const glm::vec3& view, const scene::LightArrival& arrival);

}  // namespace amalgam::trace
