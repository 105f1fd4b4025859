#include "trace/surface_point.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "trace/interpolate.h"
#include "trace/texels.h"

namespace amalgam::trace {
namespace {

float largest(const glm::vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// A hit exactly on an edge belongs to two faces, and rounding can put it beyond the other one, from
// where a secondary ray escapes. A millionth of the way towards the triangle's centre is inside, or
// a few units in the last place where those are more. rounding: a unit as a share of the triangle's
// size.
glm::vec2 pulled_inside(const glm::vec2& barycentric, float rounding) {
  constexpr float kLeast = 1.0f / (1 << 20), kMost = 0.05f, kUnits = 4.0f;
  return glm::mix(barycentric, glm::vec2(1.0f / 3.0f),
                  glm::clamp(kUnits * rounding, kLeast, kMost));
}

}  // namespace

glm::vec3 valid_shading_normal(const glm::vec3& geometric_normal, const glm::vec3& shading_normal,
                               const glm::vec3& view) {
  const glm::vec3 reflected = 2.0f * glm::dot(shading_normal, view) * shading_normal - view;
  const float threshold = std::min(0.9f * glm::dot(geometric_normal, view), 0.01f);
  const float height = glm::dot(geometric_normal, reflected);
  if (glm::dot(shading_normal, view) > 0.0f && height >= threshold) return shading_normal;
  // Lift the reflected ray to the threshold; the normal that would reflect there lies half way to
  // the view.
  const glm::vec3 lifted = glm::normalize(reflected + (threshold - height) * geometric_normal);
  const glm::vec3 half = view + lifted;
  const float length = glm::length(half);
  return length > 1e-6f ? half / length : geometric_normal;
}

scene::PhongTerms phong_terms_at(const SurfacePoint& point, scene::MaterialKind kind) {
  const glm::vec3 color(point.base_color);
  if (kind == scene::MaterialKind::Dielectric && !is_rough(point)) return {.albedo = color};
  return scene::phong_terms(color, point.metallic, point.roughness);
}

// Möller and Trumbore 1997.
Hit hit_on_line(const EmbreeScene& scene, const Hit& hit, const glm::vec3& start,
                const glm::vec3& direction) {
  const scene::Mesh& mesh = scene.scene().meshes[scene.scene().instances[hit.instance].mesh];
  const glm::dmat4 world_from_mesh(scene.placed(hit.instance).world_from_mesh);
  const glm::uvec3 corners = mesh.triangles[hit.triangle];
  const auto corner = [&](std::uint32_t index) {
    return glm::dvec3(world_from_mesh * glm::dvec4(mesh.positions[index], 1.0));
  };
  const glm::dvec3 a = corner(corners.x);
  const glm::dvec3 edge_u = corner(corners.y) - a, edge_v = corner(corners.z) - a;
  const glm::dvec3 d(direction), from_a = glm::dvec3(start) - a;
  const glm::dvec3 p = glm::cross(d, edge_v), q = glm::cross(from_a, edge_u);
  const double scale = glm::dot(edge_u, p);
  const double u = glm::dot(from_a, p) / scale, v = glm::dot(d, q) / scale;
  const double t = glm::dot(edge_v, q) / scale;
  // The line may pass a little beside the triangle that the traced ray met: then its nearest edge.
  // Far beside (seen edge-on, the two have no point in common that means anything) the traced hit
  // stays.
  constexpr double kBeside = 0.01;
  const bool usable = u > -kBeside && v > -kBeside && u + v < 1.0 + kBeside && t > 0.0;
  if (!usable) return hit;
  const glm::dvec2 inside = glm::max(glm::dvec2(u, v), glm::dvec2(0.0));
  Hit refined = hit;
  refined.barycentric = glm::vec2(inside / std::max(1.0, inside.x + inside.y));
  refined.t = static_cast<float>(t);
  return refined;
}

SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::vec3& direction,
                           float cone_width) {
  const scene::Instance& instance = scene.scene().instances[hit.instance];
  const scene::Mesh& mesh = scene.scene().meshes[instance.mesh];
  const PlacedInstance& placed = scene.placed(hit.instance);
  const glm::uvec3 corners = mesh.triangles[hit.triangle];
  const glm::vec3 a = mesh.positions[corners.x], b = mesh.positions[corners.y],
                  c = mesh.positions[corners.z];

  SurfacePoint point;
  const glm::mat4& m = placed.world_from_mesh;
  const float corner = std::max({largest(a), largest(b), largest(c)});
  const float stretch = std::max({largest(m[0]), largest(m[1]), largest(m[2])});
  point.offset = offset_height(stretch * corner + largest(m[3]));
  const float size = stretch * std::max(largest(b - a), largest(c - a));
  const float rounding = point.offset / (kOffsetUnits * std::max(size, 1e-30f));
  point.position = glm::vec3(
      m * glm::vec4(interpolate(a, b, c, pulled_inside(hit.barycentric, rounding)), 1.0f));
  // In double: the edges' product of a tiny triangle is below what float can hold.
  const glm::dvec3 area = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const glm::dvec3 outwards = glm::dmat3(placed.normal_from_mesh) * glm::normalize(area);
  const auto outside = glm::vec3(glm::normalize(outwards));
  glm::vec3 smooth =
      placed.normal_from_mesh * interpolate(mesh.normals[corners.x], mesh.normals[corners.y],
                                            mesh.normals[corners.z], hit.barycentric);
  const float length = glm::length(smooth);
  smooth = length > 0.0f ? smooth / length : outside;

  const Texels texels(scene.scene(), hit,
                      {.cosine = glm::dot(outside, direction),
                       .cone_width = cone_width,
                       .world_area_per_mesh_area = static_cast<float>(glm::length(outwards))});
  smooth = texels.bent_normal(smooth, placed);
  point.front = glm::dot(outside, direction) < 0.0f;
  const float side = point.front ? 1.0f : -1.0f;
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
