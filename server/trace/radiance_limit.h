// The largest radiance that a ray may bring back: what the truncation bound is made from
// (truncation_bound.h).
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "common/image.h"
#include "scene/light/environment.h"
#include "scene/light/light.h"
#include "scene/light/tone_map.h"
#include "trace/embree_scene.h"

namespace amalgam::trace {

// Upper limits. Glass and mirrors return at most the light that they receive, so chains of them
// need no limit of their own, except for specular surfaces that emit: a chain of those has none.
struct RadianceLimit {
  glm::vec3 radiance{0.0f};     // scene-linear: the environment, and surfaces as modelled
  glm::vec3 environment{0.0f};  // display-linear: a low-dynamic-range environment, seen as I_e
  bool looks_up = false;        // rays may also find the colors of the camera image
};

// Stands for "no limit". Finite, so that a weight of 0 times it is 0, and small enough to be
// multiplied with exposures and other radiance.
inline constexpr float kNoRadianceLimit = 1e20f;

// environment: null for black. largest_environment: largest_radiance(*environment).
RadianceLimit find_radiance_limit(const EmbreeScene& scene, std::span<const scene::Light> lights,
                                  const scene::Environment* environment,
                                  const glm::vec3& largest_environment, bool has_camera_image);

// The limit with the image's colors: TM^-1 of its brightest byte.
RadianceLimit with_camera_image(RadianceLimit limit, const common::ImageRgb8& image,
                                const scene::ToneMap& tone_map);

}  // namespace amalgam::trace
