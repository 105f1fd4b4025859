// glTF primitives read into Meshes of plain triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/materials.h"
#include "scene/gltf/model.h"
#include "scene/scene.h"

namespace amalgam::scene {

struct ReadPrimitive {
  Mesh mesh;
  std::size_t material = 0;  // index into ResolvedMaterials::materials
};

// Throws SceneError if the primitives of all meshes have more vertices or triangles than the limits
// (check/limits.h), by what their accessors say. To be asked before any is read.
void check_mesh_sizes(const tinygltf::Model& model);

// The drawable primitives of one glTF mesh: lists, strips and fans of triangles. Points, lines, and
// primitives without a triangle after repair are left out and noted. Throws SceneError for an index
// out of range.
std::vector<ReadPrimitive> read_primitives(const GltfModel& gltf, std::size_t mesh,
                                           const ResolvedMaterials& materials,
                                           std::vector<std::string>& notes);

}  // namespace amalgam::scene
