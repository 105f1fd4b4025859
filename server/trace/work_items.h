// What flows between the verbs of the tracer: declared here, before any of them.
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

// A weight as one number: its share of the sample's light.
inline float mean_channel(const glm::vec3& weight) {
  return (weight.x + weight.y + weight.z) / 3.0f;
}

enum class RayKind : std::uint8_t { Primary, Reflection, Refraction };

// A ray on its way, with its share of the sample (Listing 4.1's payload, for work lists).
struct RayItem {
  // The line itself, from the surface that it leaves.
  glm::dvec3 start{0.0};
  glm::dvec3 direction{0.0};  // unit
  // What Embree is asked: from a little off that surface, or from behind what the line passed
  // because it is masked out.
  Ray ray;
  glm::vec3 weight{
      1.0f};    // product of the k_s and k_t so far; its largest channel is the importance
  Media media;  // the dielectrics that the ray is inside of
  double path_length = 0.0;  // metres from the camera to start: how wide the ray's cone is
  std::uint32_t sample = 0;
  std::uint16_t depth = 0;  // specular surfaces met so far
  RayKind kind = RayKind::Primary;
};

// What a ray met, and with which share of its sample it arrived there.
struct MetSurface {
  SurfacePoint point;
  glm::vec3 weight{0.0f};
  double path_length = 0.0;  // metres from the camera
};

// A ray that meets nothing any more, or is cut off: takes the environment in its direction.
struct EscapedItem {
  core::LightSource source = core::LightSource::Environment;  // or CutOff
  glm::vec3 direction{0.0f};
  glm::vec3 weight{0.0f};
  std::uint32_t sample = 0;
};

// Which color a real diffuse surface has.
enum class RealColor : std::uint8_t {
  LookedUp,    // that of the camera image, where the camera sees it
  UnderPixel,  // seen directly: as it is modelled, and the composite puts the difference on the
               // camera image
  Modelled,    // the camera sees more there than this share of it
};

// A diffuse surface to be shaded: the only place that shadow rays start from.
struct DiffuseItem {
  SurfacePoint point;
  glm::vec3 view{0.0f};  // unit, towards the ray's origin
  glm::vec3 weight{0.0f};
  std::uint32_t sample = 0;
  RealColor real_color = RealColor::LookedUp;
  std::optional<CameraPlace> seen{};  // of a real surface: where the camera sees it

  // The camera says what the surface looks like; all that is asked of the lights is what virtual
  // objects change in it.
  bool only_change_counts() const { return seen && seen->trust == 1.0f; }
};

struct ShadowItem {
  glm::dvec3 start{0.0};       // on the surface
  Ray ray;                     // from a little further along
  glm::vec3 irradiance{0.0f};  // on a surface facing the light, if nothing is in the way
  std::uint32_t diffuse = 0;   // index into the batch's DiffuseItems
};

// How much of a light arrives: with everything in the way, and with only what is real in the way
// (section 4.3).
struct ShadowAttenuation {
  glm::vec3 mixed{1.0f};
  glm::vec3 real{1.0f};
  bool differs() const { return mixed != real; }
};

// Sums of a diffuse item over the lights: over all of them, or, where only mixed - real will count,
// over those that virtual objects change.
struct DiffuseRadiance {
  glm::vec3 mixed{0.0f};
  glm::vec3 real{0.0f};
};

}  // namespace amalgam::trace
