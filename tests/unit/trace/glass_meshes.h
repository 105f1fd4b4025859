// Meshes that glass is made of in tests: cavities, and surfaces with holes.
#pragma once

#include <utility>

#include "support/scene_builders.h"

namespace amalgam::trace {

// The wall of a cavity: the same surface with its outside inside.
inline scene::Mesh turned_inside_out(scene::Mesh mesh) {
  for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  return mesh;
}

// Every n-th triangle is missing.
inline scene::Mesh with_holes(scene::Mesh mesh, std::size_t n) {
  std::vector<glm::uvec3> kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % n != 0) kept.push_back(mesh.triangles[i]);
  }
  mesh.triangles = std::move(kept);
  return mesh;
}

// Another mesh of the same material, as one more instance.
inline void add_to_last_material(scene::Scene& scene, scene::Mesh mesh) {
  scene::Instance instance = scene.instances.back();
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

}  // namespace amalgam::trace
