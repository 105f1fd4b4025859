// Bounding boxes of meshes, for conservative tests.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace amalgam::scene {

// Aligned with the axes, metres. Empty (low above high) for a mesh without vertices.
struct Bounds {
  glm::vec3 low{0.0f};
  glm::vec3 high{0.0f};
};

Bounds bounds_of(const Mesh& mesh);

// By Scene::meshes.
std::vector<Bounds> mesh_bounds(const Scene& scene);

// The box's corners in the world.
std::array<glm::dvec3, 8> placed_corners(const Bounds& bounds, const glm::mat4& world_from_mesh);

}  // namespace amalgam::scene
