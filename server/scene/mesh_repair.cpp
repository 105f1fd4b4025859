#include "scene/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/mesh_vertices.h"

namespace amalgam::scene {
namespace {

// Twice the area times the normal, in double: thin triangles of a large mesh cancel in float.
glm::dvec3 area_vector(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
      c(mesh.positions[triangle.z]);
  return glm::cross(b - a, c - a);
}

// The area is nothing but rounding: below 1e-10 of the square of its longest side (a height of
// 1e-10).
bool has_no_area(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
      c(mesh.positions[triangle.z]);
  const double longest =
      std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
  constexpr double kFlat = 1e-10;
  return !(glm::length(area_vector(mesh, triangle)) > kFlat * longest);
}

void drop_triangles(Mesh& mesh, MeshRepairs& repairs) {
  std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
    if (t.x == t.y || t.y == t.z || t.z == t.x) {
      ++repairs.repeated_indices;
      return true;
    }
    if (has_no_area(mesh, t)) {
      ++repairs.zero_area;
      return true;
    }
    return false;
  });
}

void split_and_compute_flat(Mesh& mesh) {
  Mesh split;
  split.name = std::move(mesh.name);
  for (const glm::uvec3& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    const glm::vec3 normal(glm::normalize(area_vector(mesh, t)));
    for (int corner = 0; corner < 3; ++corner) {
      append_vertex(split, mesh, t[corner]);
      split.normals.push_back(normal);
    }
    split.triangles.emplace_back(first, first + 1, first + 2);
  }
  mesh = std::move(split);
}

void repair_normals(Mesh& mesh, MeshRepairs& repairs) {
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const double length = glm::length(glm::dvec3(mesh.normals[i]));
    constexpr double kMinLength = 1e-6, kMaxError = 1e-3;
    if (!(length > kMinLength) || !std::isfinite(length)) {
      bad.push_back(i);
      continue;
    }
    // Small errors are rounding and not worth a note, but are removed too.
    if (std::abs(length - 1.0) > kMaxError) ++repairs.scaled_normals;
    mesh.normals[i] = glm::vec3(glm::dvec3(mesh.normals[i]) / length);
  }
  if (bad.empty()) return;
  repairs.bad_normals = bad.size();
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 area = area_vector(mesh, t);
    for (int corner = 0; corner < 3; ++corner) sums[t[corner]] += area;
  }
  for (const std::size_t i : bad) {
    const double length = glm::length(sums[i]);
    mesh.normals[i] = length > 0.0 ? glm::vec3(sums[i] / length) : glm::vec3(0.0f, 1.0f, 0.0f);
  }
}

}  // namespace

bool MeshRepairs::any() const {
  return repeated_indices + zero_area + bad_normals + scaled_normals > 0 || computed_normals;
}

std::string MeshRepairs::describe() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (repeated_indices > 0) {
    add("dropped " + std::to_string(repeated_indices) + " triangles with repeated indices");
  }
  if (zero_area > 0) add("dropped " + std::to_string(zero_area) + " triangles without area");
  if (bad_normals > 0) add("computed " + std::to_string(bad_normals) + " unusable normals anew");
  if (scaled_normals > 0) add("brought " + std::to_string(scaled_normals) + " normals to length 1");
  if (computed_normals) add("has no normals, flat ones computed");
  return text;
}

MeshRepairs repair_mesh(Mesh& mesh) {
  MeshRepairs repairs;
  drop_triangles(mesh, repairs);
  if (mesh.normals.empty()) {
    repairs.computed_normals = true;
    split_and_compute_flat(mesh);
  } else {
    repair_normals(mesh, repairs);
  }
  return repairs;
}

}  // namespace amalgam::scene
