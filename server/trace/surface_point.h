// A ray's hit on a surface, with everything that shading needs.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "trace/embree_scene.h"
#include "trace/ray_offset.h"

namespace amalgam::trace {

struct SurfacePoint {
  // Origin of a ray in this direction that does not meet this surface again (trace/ray_offset.h).
  glm::vec3 ray_origin(const glm::dvec3& direction) const {
    return glm::vec3(offset_from_surface(inside, geometric_normal, direction, offset));
  }
  // Origin on the line from the point, a little before it, so that the ray misses nothing near. It
  // may meet this surface: is_left_behind() (trace/refine_hit.h) tells.
  glm::vec3 ray_origin_on_line(const glm::dvec3& direction) const {
    return glm::vec3(position - offset * direction);
  }

  // World, from barycentric coordinates and not from o + t d (numerics B1).
  glm::dvec3 position{0.0};
  glm::dvec3 inside{0.0};            // the same, moved a little off the triangle's edges
  double offset = 0.0;               // height above the surface at which rays start, metres
  glm::dvec3 geometric_normal{0.0};  // unit, on the side that the ray came from
  // Unit, interpolated; flipped together with the geometric one.
  glm::dvec3 shading_normal{0.0};
  glm::vec4 base_color{1.0f};  // linear; alpha
  glm::vec3 emission{0.0f};    // scene-linear radiance
  float metallic = 0.0f, roughness = 1.0f;
  float transmission = 1.0f;  // of glass
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  bool front = true;  // the ray came from the outer side (counter-clockwise corners)
};

// SurfacePoint::offset of a hit.
double offset_at(const EmbreeScene& scene, const Hit& hit);

// direction: the ray's, unit. cone_width: width of the ray's cone at the hit, metres, for the
// textures' level of detail (scene/texture_lookup.h); 0: the finest.
SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction,
                           double cone_width = 0.0);

// Too rough for a mirror image.
inline bool is_rough(const SurfacePoint& point) {
  return point.roughness > scene::kSmoothRoughness;
}

// Share of the light that takes part in mirror reflection. On rough glass, the share that is not
// transmitted gets Phong's highlight instead.
inline float mirror_share(const SurfacePoint& point) {
  return is_rough(point) ? point.transmission : 1.0f;
}

// Phong's terms of a diffuse surface, or of the light that glass does not transmit. For smooth
// glass they are Lambertian, because its mirror image is traced.
scene::PhongTerms phong_terms_at(const SurfacePoint& point, scene::MaterialKind kind);

// Bends a shading normal so that the reflected ray leaves the geometric surface by at least a small
// angle (numerics B10: Keller's method with the threshold of Cycles'
// ensure_valid_specular_reflection). view: unit, towards the ray's origin, above the geometric
// surface.
glm::dvec3 valid_shading_normal(const glm::dvec3& geometric_normal,
                                const glm::dvec3& shading_normal, const glm::dvec3& view);

// Bends a refracted ray so that it leaves the geometric surface on the other side, by at least a
// very small angle (numerics B10). Needed where a ray leaves glass near the critical angle and the
// shading normal leans: the refracted ray would go on inside the mesh as if it were in air.
// geometric_normal: on the side that the ray came from.
glm::dvec3 valid_refraction(const glm::dvec3& geometric_normal, const glm::dvec3& refracted);

}  // namespace amalgam::trace
