#include "trace/surface_point.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "trace/interpolate.h"
#include "trace/texels.h"

namespace amalgam::trace {
namespace {

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

glm::dvec3 unit(const glm::dvec3& v) {
  return v * (1.0 / std::sqrt(glm::dot(v, v)));
}

// A hit exactly on an edge belongs to two faces. Rounding can put it behind the other face, where a
// secondary ray escapes. So it moves towards the triangle's centre by a millionth of the way, or by
// a few units in the last place of float if those are more. rounding: one such unit as a share of
// the triangle's size.
double share_of_way_inside(double rounding) {
  constexpr double kLeast = 1.0 / (1 << 20), kMost = 0.05, kUnits = 4.0;
  return std::clamp(kUnits * rounding, kLeast, kMost);
}

// The properties of a material without textures or vertex colors.
void take_factors(const scene::Material& material, SurfacePoint& point) {
  point.base_color = material.base_color;
  point.emission = material.emission;
  point.metallic = material.metallic;
  point.roughness = material.roughness;
  point.transmission = material.transmission;
}

void take_texels(const Texels& texels, SurfacePoint& point) {
  point.base_color = texels.base_color();
  point.emission = texels.emission();
  const glm::vec2 metallic_roughness = texels.metallic_roughness();
  point.metallic = metallic_roughness.x;
  point.roughness = metallic_roughness.y;
  point.transmission = texels.transmission();
}

}  // namespace

glm::dvec3 valid_shading_normal(const glm::dvec3& geometric_normal,
                                const glm::dvec3& shading_normal, const glm::dvec3& view) {
  const glm::dvec3 reflected = 2.0 * glm::dot(shading_normal, view) * shading_normal - view;
  const double threshold = std::min(0.9 * glm::dot(geometric_normal, view), 0.01);
  const double height = glm::dot(geometric_normal, reflected);
  if (glm::dot(shading_normal, view) > 0.0 && height >= threshold) return shading_normal;
  // Lift the reflected ray to the threshold. The normal for it lies half way to the view.
  const glm::dvec3 lifted = glm::normalize(reflected + (threshold - height) * geometric_normal);
  const glm::dvec3 half = view + lifted;
  const double length = glm::length(half);
  return length > 1e-6 ? half / length : geometric_normal;
}

glm::dvec3 valid_refraction(const glm::dvec3& geometric_normal, const glm::dvec3& refracted) {
  constexpr double kLeast = 1e-5;
  const double height = glm::dot(geometric_normal, refracted);
  if (height <= -kLeast) return refracted;
  return glm::normalize(refracted - (height + kLeast) * geometric_normal);
}

scene::PhongTerms phong_terms_at(const SurfacePoint& point, scene::MaterialKind kind) {
  const glm::vec3 color(point.base_color);
  if (kind == scene::MaterialKind::Dielectric && !is_rough(point)) return {.albedo = color};
  return scene::phong_terms(color, point.metallic, point.roughness);
}

double offset_at(const EmbreeScene& scene, const Hit& hit) {
  double corner = 0.0;
  for (const glm::vec3& p : scene.triangle(hit).corners) {
    corner = std::max(corner, largest(glm::dvec3(p)));
  }
  const PlacedInstance& placed = scene.placed(hit.instance);
  return offset_height(placed.stretch * corner + placed.reach);
}

SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction,
                           double cone_width) {
  const PlacedInstance& placed = scene.placed(hit.instance);
  const MeshTriangle& triangle = scene.triangle(hit);
  const glm::dvec3 a(triangle.corners[0]), b(triangle.corners[1]), c(triangle.corners[2]);
  const glm::dvec3 edge_u = b - a, edge_v = c - a;

  SurfacePoint point;
  point.offset = offset_at(scene, hit);
  const double size = placed.stretch * std::max(largest(edge_u), largest(edge_v));
  const double rounding = point.offset / (kOffsetUnits * std::max(size, 1e-30));
  const glm::dvec2& at = hit.barycentric;
  point.position =
      glm::dvec3(placed.world_from_mesh * glm::dvec4(a + at.x * edge_u + at.y * edge_v, 1.0));
  const glm::dvec3 to_centre = (1.0 / 3.0 - at.x) * edge_u + (1.0 / 3.0 - at.y) * edge_v;
  point.inside = point.position +
                 share_of_way_inside(rounding) * (glm::dmat3(placed.world_from_mesh) * to_centre);

  const glm::dvec3 outside = unit(placed.normal_from_mesh * glm::cross(edge_u, edge_v));
  const glm::dvec3 interpolated =
      interpolate(glm::dvec3(triangle.normals[0]), glm::dvec3(triangle.normals[1]),
                  glm::dvec3(triangle.normals[2]), at);
  glm::dvec3 smooth = placed.normal_from_mesh * interpolated;
  const double length2 = glm::dot(smooth, smooth);
  smooth = length2 > 0.0 ? smooth * (1.0 / std::sqrt(length2)) : outside;

  if (placed.textured) {
    const double world_area_per_mesh_area =
        glm::length(placed.normal_from_mesh * unit(glm::cross(edge_u, edge_v)));
    const Texels texels(scene.scene(), hit,
                        {.cosine = static_cast<float>(glm::dot(outside, direction)),
                         .cone_width = static_cast<float>(cone_width),
                         .world_area_per_mesh_area = static_cast<float>(world_area_per_mesh_area)});
    smooth = texels.bent_normal(smooth, placed);
    take_texels(texels, point);
  } else {
    take_factors(scene.scene().materials[placed.material], point);
  }
  point.front = glm::dot(outside, direction) < 0.0;
  const double side = point.front ? 1.0 : -1.0;
  point.geometric_normal = side * outside;
  point.shading_normal = side * smooth;
  point.material = placed.material;
  point.role = placed.role;
  return point;
}

}  // namespace amalgam::trace
