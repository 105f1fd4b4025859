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

// A hit exactly on an edge belongs to two faces, and rounding can put it beyond the other one, from
// where a secondary ray escapes. A millionth of the way towards the triangle's centre is inside, or
// a few units of float in the last place where those are more. rounding: a unit as a share of the
// triangle's size.
glm::dvec2 pulled_inside(const glm::dvec2& barycentric, double rounding) {
  constexpr double kLeast = 1.0 / (1 << 20), kMost = 0.05, kUnits = 4.0;
  return glm::mix(barycentric, glm::dvec2(1.0 / 3.0), glm::clamp(kUnits * rounding, kLeast, kMost));
}

}  // namespace

glm::dvec3 valid_shading_normal(const glm::dvec3& geometric_normal,
                                const glm::dvec3& shading_normal, const glm::dvec3& view) {
  const glm::dvec3 reflected = 2.0 * glm::dot(shading_normal, view) * shading_normal - view;
  const double threshold = std::min(0.9 * glm::dot(geometric_normal, view), 0.01);
  const double height = glm::dot(geometric_normal, reflected);
  if (glm::dot(shading_normal, view) > 0.0 && height >= threshold) return shading_normal;
  // Lift the reflected ray to the threshold; the normal that would reflect there lies half way to
  // the view.
  const glm::dvec3 lifted = glm::normalize(reflected + (threshold - height) * geometric_normal);
  const glm::dvec3 half = view + lifted;
  const double length = glm::length(half);
  return length > 1e-6 ? half / length : geometric_normal;
}

scene::PhongTerms phong_terms_at(const SurfacePoint& point, scene::MaterialKind kind) {
  const glm::vec3 color(point.base_color);
  if (kind == scene::MaterialKind::Dielectric && !is_rough(point)) return {.albedo = color};
  return scene::phong_terms(color, point.metallic, point.roughness);
}

SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction,
                           double cone_width) {
  const scene::Instance& instance = scene.scene().instances[hit.instance];
  const scene::Mesh& mesh = scene.scene().meshes[instance.mesh];
  const PlacedInstance& placed = scene.placed(hit.instance);
  const glm::uvec3 corners = mesh.triangles[hit.triangle];
  const glm::dvec3 a(mesh.positions[corners.x]), b(mesh.positions[corners.y]),
      c(mesh.positions[corners.z]);

  SurfacePoint point;
  const glm::dmat4& m = placed.world_from_mesh;
  const double corner = std::max({largest(a), largest(b), largest(c)});
  const double stretch = std::max({largest(m[0]), largest(m[1]), largest(m[2])});
  point.offset = offset_height(stretch * corner + largest(m[3]));
  const double size = stretch * std::max(largest(b - a), largest(c - a));
  const double rounding = point.offset / (kOffsetUnits * std::max(size, 1e-30));
  const auto at = [&](const glm::dvec2& barycentric) {
    return glm::dvec3(m * glm::dvec4(interpolate(a, b, c, barycentric), 1.0));
  };
  point.position = at(hit.barycentric);
  point.inside = at(pulled_inside(hit.barycentric, rounding));
  const glm::dvec3 area = glm::cross(b - a, c - a);
  const glm::dvec3 outwards = placed.normal_from_mesh * glm::normalize(area);
  const glm::dvec3 outside = glm::normalize(outwards);
  const glm::dvec3 interpolated =
      interpolate(glm::dvec3(mesh.normals[corners.x]), glm::dvec3(mesh.normals[corners.y]),
                  glm::dvec3(mesh.normals[corners.z]), hit.barycentric);
  glm::dvec3 smooth = placed.normal_from_mesh * interpolated;
  const double length = glm::length(smooth);
  smooth = length > 0.0 ? smooth / length : outside;

  const Texels texels(scene.scene(), hit,
                      {.cosine = static_cast<float>(glm::dot(outside, direction)),
                       .cone_width = static_cast<float>(cone_width),
                       .world_area_per_mesh_area = static_cast<float>(glm::length(outwards))});
  smooth = texels.bent_normal(smooth, placed);
  point.front = glm::dot(outside, direction) < 0.0;
  const double side = point.front ? 1.0 : -1.0;
  point.geometric_normal = side * outside;
  point.shading_normal = side * smooth;
  point.material = instance.material;
  point.role = instance.role;
  point.base_color = texels.base_color();
  point.emission = texels.emission();
  const glm::vec2 metallic_roughness = texels.metallic_roughness();
  point.metallic = metallic_roughness.x;
  point.roughness = metallic_roughness.y;
  point.transmission = texels.transmission();
  return point;
}

}  // namespace amalgam::trace
