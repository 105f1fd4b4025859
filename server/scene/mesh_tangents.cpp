#include "scene/mesh_tangents.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "scene/mesh_vertices.h"

namespace amalgam::scene {
namespace {

glm::vec4 cleaned(const glm::vec4& tangent) {
  const glm::vec3 direction(tangent);
  const float length = glm::length(direction);
  if (!(length > 1e-6f) || !std::isfinite(length)) return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  return {direction / length, tangent.w < 0.0f ? -1.0f : 1.0f};
}

// Along +u in mesh space, not unit: large where a triangle is. handedness: +1 if the picture shows
// from outside as it is painted (v points down), -1 mirrored, 0 if the coordinates have no area.
struct TriangleTangent {
  glm::dvec3 along_u{0.0};
  int handedness = 0;
};

TriangleTangent tangent_of(const Mesh& mesh, const std::vector<glm::vec2>& uvs,
                           const glm::uvec3& corners) {
  const glm::dvec3 a(mesh.positions[corners.x]);
  const glm::dvec3 ab = glm::dvec3(mesh.positions[corners.y]) - a;
  const glm::dvec3 ac = glm::dvec3(mesh.positions[corners.z]) - a;
  const glm::dvec2 u(uvs[corners.x]);
  const glm::dvec2 uv = glm::dvec2(uvs[corners.y]) - u, uw = glm::dvec2(uvs[corners.z]) - u;
  const double determinant = uv.x * uw.y - uw.x * uv.y;
  if (determinant == 0.0 || !std::isfinite(determinant)) return {};
  const double sign = determinant < 0.0 ? -1.0 : 1.0;
  // Corners run counter-clockwise; with v pointing down they do so in the picture too if the
  // determinant is negative.
  return {sign * (uw.y * ab - uv.y * ac), determinant < 0.0 ? 1 : -1};
}

// Gives triangles of negative handedness vertices of their own.
void split_mirrored(Mesh& mesh, const std::vector<TriangleTangent>& tangents) {
  std::vector<bool> used_plain(mesh.positions.size(), false);
  for (std::size_t t = 0; t < tangents.size(); ++t) {
    if (tangents[t].handedness < 0) continue;
    for (int corner = 0; corner < 3; ++corner) used_plain[mesh.triangles[t][corner]] = true;
  }
  std::map<std::uint32_t, std::uint32_t> mirrored;
  for (std::size_t t = 0; t < tangents.size(); ++t) {
    if (tangents[t].handedness >= 0) continue;
    for (int corner = 0; corner < 3; ++corner) {
      std::uint32_t& vertex = mesh.triangles[t][corner];
      if (!used_plain[vertex]) continue;
      const auto [copy, is_new] =
          mirrored.try_emplace(vertex, static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) append_vertex(mesh, mesh, vertex);
      vertex = copy->second;
    }
  }
}

}  // namespace

void complete_tangents(Mesh& mesh, bool from_second_uvs) {
  for (glm::vec4& tangent : mesh.tangents) tangent = cleaned(tangent);
  const auto& uvs = from_second_uvs ? mesh.second_uvs : mesh.uvs;
  if (uvs.empty()) mesh.tangents.clear();
  if (uvs.empty() || !mesh.tangents.empty()) return;

  std::vector<TriangleTangent> of_triangles;
  for (const glm::uvec3& corners : mesh.triangles) {
    of_triangles.push_back(tangent_of(mesh, uvs, corners));
  }
  split_mirrored(mesh, of_triangles);
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  std::vector<float> handedness(mesh.positions.size(), 1.0f);
  for (std::size_t t = 0; t < of_triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = mesh.triangles[t][corner];
      sums[vertex] += of_triangles[t].along_u;
      if (of_triangles[t].handedness < 0) handedness[vertex] = -1.0f;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const glm::dvec3 normal(mesh.normals[i]);
    const glm::dvec3 along = sums[i] - glm::dot(sums[i], normal) * normal;
    const double length = glm::length(along), whole = glm::length(sums[i]);
    const bool usable = length > 1e-6 * whole && std::isfinite(length);
    mesh.tangents.emplace_back(usable ? glm::vec3(along / length) : glm::vec3(0.0f), handedness[i]);
  }
}

}  // namespace amalgam::scene
