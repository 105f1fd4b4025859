// The work items in the queues between the tracer's verbs.
//
// All colors are scene-linear unless they say display-linear. "Sample" is an index into the tile's
// SampleResults (tile_paths.h).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "core/provenance.h"
#include "trace/camera_lookup.h"
#include "trace/embree_scene.h"
#include "trace/media.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// A weight as a scalar: the mean share of the sample's light.
inline float mean_channel(const glm::vec3& weight) {
  return (weight.x + weight.y + weight.z) / 3.0f;
}

enum class RayKind : std::uint8_t { Primary, Reflection, Refraction };

// A ray to be traced, with its weight in the sample (the payload of Listing 4.1).
struct RayItem {
  // The exact line, from the surface that it leaves.
  glm::dvec3 start{0.0};
  glm::dvec3 direction{0.0};  // unit
  // The ray for Embree. It starts a little off that surface, or behind the alpha cut-outs that the
  // line has passed.
  Ray ray;
  // Product of the k_s and k_t so far; its largest channel is the importance. It counts what is
  // conserved across an interface, radiance over the squared index of refraction
  // (Tile::light_weight).
  glm::vec3 weight{1.0f};
  Media media;               // the dielectrics that the ray is inside
  double path_length = 0.0;  // metres from the camera to start: gives the width of the ray's cone
  std::uint32_t sample = 0;
  std::uint16_t depth = 0;  // specular surfaces met so far
  RayKind kind = RayKind::Primary;
};

// A ray's hit, with the ray's weight on arrival.
struct MetSurface {
  SurfacePoint point;
  glm::vec3 weight{0.0f};
  double path_length = 0.0;  // metres from the camera
};

// A ray that left the scene or was cut off. It takes the environment in its direction.
struct EscapedItem {
  core::LightSource source = core::LightSource::Environment;  // or CutOff
  glm::vec3 direction{0.0f};
  glm::vec3 weight{0.0f};
  std::uint32_t sample = 0;
};

// Where the color of a real diffuse surface comes from.
enum class RealColor : std::uint8_t {
  LookedUp,  // from the camera image, where the camera sees it
  // Hit by a primary ray: shaded as modelled, and the composite adds D to the camera image.
  UnderPixel,
  Modelled,  // shaded as modelled: the camera sees more than this share
};

// A diffuse surface to be shaded. Shadow rays start only here.
struct DiffuseItem {
  SurfacePoint point;
  glm::vec3 view{0.0f};    // unit, towards the ray's origin
  glm::vec3 weight{0.0f};  // of its radiance in the sample
  float share = 0.0f;      // of the sample's light, for provenance
  std::uint32_t sample = 0;
  RealColor real_color = RealColor::LookedUp;
  // immersion_gain() of the media around, and of the real ones.
  glm::vec3 mixed_gain{1.0f}, real_gain{1.0f};
  std::optional<CameraPlace> seen{};  // the pixel of a real surface that the camera sees

  // The camera gives the surface's color. Of the lights, only the change by virtual objects counts.
  bool only_change_counts() const { return seen && seen->trust == 1.0f && mixed_gain == real_gain; }
};

struct ShadowItem {
  glm::dvec3 start{0.0};       // on the surface
  Ray ray;                     // starts a little before, on the line
  glm::vec3 irradiance{0.0f};  // unoccluded, on a surface facing the light
  std::uint32_t diffuse = 0;   // index into the batch's DiffuseItems
};

// Transmittance from a light to a point: through all objects, and through the real ones only
// (section 4.3).
struct ShadowAttenuation {
  glm::vec3 mixed{1.0f};
  glm::vec3 real{1.0f};
  bool differs() const { return mixed != real; }
};

// Radiance of a diffuse item, summed over the lights. If only_change_counts(), a sum without change
// may skip lights; by differences, every sum skips those that virtual objects do not change.
struct DiffuseRadiance {
  glm::vec3 mixed{0.0f};
  glm::vec3 real{0.0f};
};

}  // namespace amalgam::trace
