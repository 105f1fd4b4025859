#include "trace/surface_point.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "trace/interpolate.h"
#include "trace/texels.h"

namespace amalgam::trace {
namespace {

// A hit exactly on an edge belongs to two faces, and rounding can put it beyond the other one, from
// where a secondary ray escapes. A millionth of the way towards the triangle's centre is inside.
glm::vec2 pulled_inside(const glm::vec2& barycentric) {
  constexpr float kPull = 1.0f / (1 << 20);
  return glm::mix(barycentric, glm::vec2(1.0f / 3.0f), kPull);
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
  if (kind == scene::MaterialKind::Dielectric) return {.albedo = color};
  return scene::phong_terms(color, point.metallic, point.roughness);
}

SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::vec3& direction,
                           float cone_width) {
  const scene::Instance& instance = scene.scene().instances[hit.instance];
  const scene::Mesh& mesh = scene.scene().meshes[instance.mesh];
  const scene::Material& material = scene.scene().materials[instance.material];
  const PlacedInstance& placed = scene.placed(hit.instance);
  const glm::uvec3 corners = mesh.triangles[hit.triangle];
  const glm::vec3 a = mesh.positions[corners.x], b = mesh.positions[corners.y],
                  c = mesh.positions[corners.z];

  SurfacePoint point;
  point.position = glm::vec3(placed.world_from_mesh *
                             glm::vec4(interpolate(a, b, c, pulled_inside(hit.barycentric)), 1.0f));
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
  if (scene::is_specular(material.kind)) {
    point.shading_normal =
        valid_shading_normal(point.geometric_normal, point.shading_normal, -direction);
  }
  return point;
}

}  // namespace amalgam::trace
