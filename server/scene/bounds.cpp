#include "scene/bounds.h"

#include <glm/common.hpp>
#include <limits>

namespace amalgam::scene {

Bounds bounds_of(const Mesh& mesh) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Bounds bounds{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
  for (const glm::vec3& position : mesh.positions) {
    bounds.low = glm::min(bounds.low, position);
    bounds.high = glm::max(bounds.high, position);
  }
  return bounds;
}

std::vector<Bounds> mesh_bounds(const Scene& scene) {
  std::vector<Bounds> bounds;
  for (const Mesh& mesh : scene.meshes) bounds.push_back(bounds_of(mesh));
  return bounds;
}

std::array<glm::dvec3, 8> placed_corners(const Bounds& bounds, const glm::mat4& world_from_mesh) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i) {
    const glm::dvec4 corner((i & 1u) != 0 ? bounds.high.x : bounds.low.x,
                            (i & 2u) != 0 ? bounds.high.y : bounds.low.y,
                            (i & 4u) != 0 ? bounds.high.z : bounds.low.z, 1.0);
    corners[i] = glm::dvec3(glm::dmat4(world_from_mesh) * corner);
  }
  return corners;
}

}  // namespace amalgam::scene
