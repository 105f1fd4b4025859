// Where a ray met a surface, with all that shading asks about the place.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "trace/embree_scene.h"
#include "trace/ray_offset.h"

namespace amalgam::trace {

struct SurfacePoint {
  // Where a ray in this direction may start without meeting this surface again
  // (trace/ray_offset.h).
  glm::vec3 ray_origin(const glm::dvec3& direction) const {
    return glm::vec3(offset_from_surface(inside, geometric_normal, direction, offset));
  }
  glm::vec3 ray_origin_on_line(const glm::dvec3& direction) const {
    return glm::vec3(offset_along_ray(inside, geometric_normal, direction, offset));
  }

  // World, from barycentric coordinates and not from o + t d (numerics B1).
  glm::dvec3 position{0.0};
  glm::dvec3 inside{0.0};            // the same a little away from the triangle's edges
  double offset = 0.0;               // height above the surface that rays start at, metres
  glm::dvec3 geometric_normal{0.0};  // unit, on the side that the ray came from
  glm::dvec3 shading_normal{
      0.0};                    // unit, interpolated; turned over together with the geometric one
  glm::vec4 base_color{1.0f};  // linear; alpha
  glm::vec3 emission{0.0f};    // scene-linear radiance
  float metallic = 0.0f, roughness = 1.0f;
  float transmission = 1.0f;  // of glass
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  bool front = true;  // the ray came from the outer side (counter-clockwise corners)
};

// direction: the ray's, unit. cone_width: metres across the ray's cone at the hit, which decides on
// the textures' level of detail (scene/texture_lookup.h); 0: the finest.
SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction,
                           double cone_width = 0.0);

// Too rough for a mirror image.
inline bool is_rough(const SurfacePoint& point) {
  return point.roughness > scene::kSmoothRoughness;
}

// What a rough surface does not let through has no mirror image: Phong's highlight stands for it.
inline float mirror_share(const SurfacePoint& point) {
  return is_rough(point) ? point.transmission : 1.0f;
}

// What a diffuse surface does at the point, or what glass does with the light that it does not let
// through: smooth glass is Lambertian, because its mirror image is traced.
scene::PhongTerms phong_terms_at(const SurfacePoint& point, scene::MaterialKind kind);

// Bends a shading normal until the reflection of the view about it leaves the surface at a small
// angle at least (numerics B10: Keller's method with the threshold of Cycles'
// ensure_valid_specular_reflection). view: unit, towards the ray's origin, above the geometric
// surface.
glm::dvec3 valid_shading_normal(const glm::dvec3& geometric_normal,
                                const glm::dvec3& shading_normal, const glm::dvec3& view);

}  // namespace amalgam::trace
