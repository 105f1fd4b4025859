#include "scene/gltf/meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "scene/gltf/accessor.h"
#include "scene/gltf/check/limits.h"
#include "scene/mesh_repair.h"
#include "scene/mesh_tangents.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

std::uint32_t restart_value(int component) {
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 0xFF;
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 0xFFFF;
  return std::numeric_limits<std::uint32_t>::max();
}

std::vector<std::uint32_t> vertex_order(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive, std::size_t vertices,
                                        const std::string& where) {
  if (primitive.indices < 0) {
    std::vector<std::uint32_t> order(vertices);
    std::iota(order.begin(), order.end(), 0u);
    return order;
  }
  auto order = read_indices(model, primitive.indices);
  const int component = model.accessors[static_cast<std::size_t>(primitive.indices)].componentType;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] == restart_value(component)) {
      throw SceneError(where + ".indices: element " + std::to_string(i) +
                       " is the primitive restart value");
    }
    if (order[i] >= vertices) {
      throw SceneError(where + ".indices: element " + std::to_string(i) + " is " +
                       std::to_string(order[i]) + ", but there are " + std::to_string(vertices) +
                       " vertices");
    }
  }
  return order;
}

// Strips and fans turn every second triangle so that all have the same winding (glTF 2.0, 3.7.2.1).
std::vector<glm::uvec3> triangles_of(const std::vector<std::uint32_t>& order, int mode) {
  std::vector<glm::uvec3> triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < order.size(); i += 3) {
      triangles.emplace_back(order[i], order[i + 1], order[i + 2]);
    }
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    for (std::size_t i = 0; i + 2 < order.size(); ++i) {
      const std::size_t odd = i % 2;
      triangles.emplace_back(order[i], order[i + 1 + odd], order[i + 2 - odd]);
    }
  } else {
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      triangles.emplace_back(order[i], order[i + 1], order[0]);
    }
  }
  return triangles;
}

void transform_uvs(std::vector<glm::vec2>& uvs, const TextureUse& use) {
  const float c = std::cos(use.rotation), s = std::sin(use.rotation);
  for (glm::vec2& uv : uvs) {
    const glm::vec2 scaled = uv * use.scale;
    // KHR_texture_transform: rotation counter-clockwise about the origin, with v pointing down.
    uv = glm::vec2(c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y) + use.offset;
  }
}

// Alpha is 1 where the file gives RGB only. Colors are linear (glTF 2.0, 3.7.2.1) and at most 1.
std::vector<glm::vec4> read_colors(const tinygltf::Model& model, int accessor) {
  const bool alpha = model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC4;
  std::vector<glm::vec4> colors;
  if (alpha) {
    colors = read_vec4(model, accessor);
  } else {
    for (const glm::vec3& rgb : read_vec3(model, accessor)) colors.emplace_back(rgb, 1.0f);
  }
  for (glm::vec4& color : colors) color = glm::clamp(color, 0.0f, 1.0f);
  return colors;
}

bool is_triangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

int accessor_of(const tinygltf::Primitive& primitive, const std::string& attribute) {
  const auto found = primitive.attributes.find(attribute);
  return found == primitive.attributes.end() ? -1 : found->second;
}

std::string path_of(std::size_t mesh, std::size_t primitive) {
  return "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(primitive) + "]";
}

// Strips and fans have nearly a triangle for each index. The indices of points and lines are read
// too, though not drawn.
std::size_t triangle_count(std::size_t indices, int mode) {
  const bool is_row = mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
  return is_row ? indices : indices / 3;
}

// An accessor in a Draco block may be joined by others that are not, each with a count of its own.
void check_lengths(const Mesh& mesh, const std::string& where) {
  const auto fits = [&](const auto& values) {
    return values.empty() || values.size() == mesh.positions.size();
  };
  if (!fits(mesh.normals) || !fits(mesh.uvs) || !fits(mesh.second_uvs) || !fits(mesh.colors) ||
      !fits(mesh.tangents)) {
    throw SceneError(where + ": its attributes have different numbers of vertices");
  }
}

}  // namespace

void check_mesh_sizes(const tinygltf::Model& model) {
  const auto count_of = [&](int accessor) {
    return model.accessors[static_cast<std::size_t>(accessor)].count;
  };
  std::size_t vertices = 0, triangles = 0;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    for (std::size_t k = 0; k < model.meshes[i].primitives.size(); ++k) {
      const tinygltf::Primitive& primitive = model.meshes[i].primitives[k];
      const int positions = accessor_of(primitive, "POSITION");
      if (positions < 0) continue;
      const std::size_t indices = count_of(primitive.indices >= 0 ? primitive.indices : positions);
      // Flat normals give each triangle vertices of its own.
      const bool is_flat = accessor_of(primitive, "NORMAL") < 0 && is_triangles(primitive.mode);
      const std::size_t drawn = triangle_count(indices, primitive.mode);
      vertices += is_flat ? std::max(count_of(positions), 3 * drawn) : count_of(positions);
      triangles += drawn;
      if (vertices > kMaxVertices) {
        throw SceneError(path_of(i, k) + ": the meshes have more than 50 million vertices");
      }
      if (triangles > kMaxTriangles) {
        throw SceneError(path_of(i, k) + ": the meshes have more than 50 million triangles");
      }
    }
  }
}

std::vector<ReadPrimitive> read_primitives(const GltfModel& gltf, std::size_t mesh_index,
                                           const ResolvedMaterials& materials,
                                           std::vector<std::string>& notes) {
  const tinygltf::Model& model = gltf.model;
  const tinygltf::Mesh& from = model.meshes[mesh_index];
  std::vector<ReadPrimitive> read;
  for (std::size_t i = 0; i < from.primitives.size(); ++i) {
    const tinygltf::Primitive& primitive = from.primitives[i];
    const std::string where = path_of(mesh_index, i);
    const auto note = [&](const std::string& what) { notes.push_back(where + ": " + what); };
    const auto attribute = [&](const std::string& name) { return accessor_of(primitive, name); };
    if (attribute("POSITION") < 0) continue;  // noted by the check

    ReadPrimitive out;
    out.material = primitive.material >= 0 ? static_cast<std::size_t>(primitive.material)
                                           : materials.materials.size() - 1;
    out.mesh.name = from.name.empty() ? where : from.name;
    out.mesh.positions = read_vec3(model, attribute("POSITION"));
    const auto order = vertex_order(model, primitive, out.mesh.positions.size(), where);
    // tinygltf gives 4 where the file says nothing, as it should.
    if (!is_triangles(primitive.mode)) {
      note("points and lines are not drawn");
      continue;
    }
    out.mesh.triangles = triangles_of(order, primitive.mode);
    if (attribute("NORMAL") >= 0) out.mesh.normals = read_vec3(model, attribute("NORMAL"));
    const Material& material = materials.materials[out.material];
    const std::vector<TextureUse>& uses = materials.texture_uses[out.material];
    for (std::size_t i_use = 0; i_use < uses.size(); ++i_use) {
      const int uvs = attribute("TEXCOORD_" + std::to_string(uses[i_use].uv_set));
      if (uvs < 0) {
        note("has no texture coordinates for its texture");
        continue;
      }
      auto& read_uvs = i_use == 0 ? out.mesh.uvs : out.mesh.second_uvs;
      read_uvs = read_vec2(model, uvs);
      transform_uvs(read_uvs, uses[i_use]);
    }
    if (attribute("COLOR_0") >= 0) out.mesh.colors = read_colors(model, attribute("COLOR_0"));
    // Tangents say nothing where the file leaves normals to the reader (glTF 2.0, 3.7.2.1).
    if (attribute("TANGENT") >= 0 && material.normal_texture && !out.mesh.normals.empty())
      out.mesh.tangents = read_vec4(model, attribute("TANGENT"));

    check_lengths(out.mesh, where);
    const MeshRepairs repairs = repair_mesh(out.mesh);
    if (repairs.any()) note(repairs.describe());
    if (material.normal_texture) {
      complete_tangents(out.mesh, material.reads_second_uvs(TextureSlot::Normal));
    }
    if (out.mesh.triangles.empty()) {
      note("has no triangles");
      continue;
    }
    read.push_back(std::move(out));
  }
  return read;
}

}  // namespace amalgam::scene
