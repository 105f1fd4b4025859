// Distant light: an equirectangular map, and its look-up by direction.
//
// Orientation (OpenEXR's latitude-longitude convention): image centre +Z, left quarter +X, right
// quarter -X, top row +Y. Directions are in the world frame.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/image.h"

namespace amalgam::scene {

struct Environment {
  // Radiance, scene-linear, finite and >= 0 (sanitised at load: numerics B16). For a
  // low-dynamic-range map the values are display-linear in [0, 1] and must never be tone-mapped:
  // they go to I_e.
  common::ImageRgb32f radiance;
  bool low_dynamic_range = false;
};

// Continuous pixel coordinates of a unit direction: column in [-0.5, width - 0.5), row in [-0.5,
// height - 0.5].
glm::vec2 environment_pixel(const Environment& environment, const glm::vec3& direction);

// The unit direction of continuous pixel coordinates.
glm::vec3 environment_direction(const Environment& environment, const glm::vec2& pixel);

// Of each texel in row y, in sr. All texels together make 4 pi.
double texel_solid_angle(const Environment& environment, int y);

// The largest value of each channel.
glm::vec3 largest_radiance(const Environment& environment);

// Bilinear look-up; wraps around in longitude, clamps at the poles.
glm::vec3 sample_environment(const Environment& environment, const glm::vec3& direction);

}  // namespace amalgam::scene
