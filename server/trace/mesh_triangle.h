// A triangle as the tracer reads it, contiguous in memory: incoherent rays meet triangles in random
// order and spend most of their time waiting for memory.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace amalgam::trace {

struct MeshTriangle {
  std::array<glm::vec3, 3> corners;  // mesh frame, metres
  std::array<glm::vec3, 3> normals;  // of the corners, unit

  // Fetches the triangle into the cache ahead of its use.
  void prefetch() const {
    const char* bytes = reinterpret_cast<const char*>(this);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + sizeof(MeshTriangle) - 1);
  }
};

inline std::vector<MeshTriangle> mesh_triangles(const scene::Mesh& mesh) {
  std::vector<MeshTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) {
    triangles.push_back({{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]},
                         {mesh.normals[t.x], mesh.normals[t.y], mesh.normals[t.z]}});
  }
  return triangles;
}

}  // namespace amalgam::trace
