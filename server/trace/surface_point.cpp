#include "trace/surface_point.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/texture_lookup.h"

namespace amalgam::trace {
namespace {

template <typename V>
V interpolate(const V& a, const V& b, const V& c, const glm::vec2& barycentric) {
  return a * (1.0f - barycentric.x - barycentric.y) + b * barycentric.x + c * barycentric.y;
}

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

SurfacePoint surface_point(const EmbreeScene& scene, const Hit& hit, const glm::vec3& direction) {
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
  const auto outside =
      glm::vec3(glm::normalize(glm::dmat3(placed.normal_from_mesh) * glm::normalize(area)));
  glm::vec3 smooth =
      placed.normal_from_mesh * interpolate(mesh.normals[corners.x], mesh.normals[corners.y],
                                            mesh.normals[corners.z], hit.barycentric);
  const float length = glm::length(smooth);
  smooth = length > 0.0f ? smooth / length : outside;

  point.front = glm::dot(outside, direction) < 0.0f;
  const float side = point.front ? 1.0f : -1.0f;
  point.geometric_normal = side * outside;
  point.shading_normal = side * smooth;
  point.material = instance.material;
  point.role = instance.role;
  point.base_color = material.base_color;
  if (material.base_color_texture && !mesh.uvs.empty()) {
    const glm::vec2 uv =
        interpolate(mesh.uvs[corners.x], mesh.uvs[corners.y], mesh.uvs[corners.z], hit.barycentric);
    point.base_color *=
        scene::sample_color_texture(scene.scene().textures[*material.base_color_texture], uv);
  }
  if (scene::is_specular(material.kind)) {
    point.shading_normal =
        valid_shading_normal(point.geometric_normal, point.shading_normal, -direction);
  }
  return point;
}

}  // namespace amalgam::trace
