#include "scene/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <tuple>

namespace amalgam::scene {
namespace {

// For each vertex the number of its position.
std::vector<std::uint32_t> position_ids(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> ids(order.size());
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i]) != key(order[i - 1])) ++id;
    ids[order[i]] = id;
  }
  return ids;
}

struct Triangle {
  glm::dvec3 a, b, c;
};

Triangle triangle_of(const Mesh& mesh, const glm::uvec3& t, const glm::dvec3& origin) {
  return {glm::dvec3(mesh.positions[t.x]) - origin, glm::dvec3(mesh.positions[t.y]) - origin,
          glm::dvec3(mesh.positions[t.z]) - origin};
}

}  // namespace

bool is_closed(const Mesh& mesh) {
  if (mesh.triangles.empty()) return false;
  const auto ids = position_ids(mesh);
  // From the lower to the higher number, and +1 or -1 for the direction.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, int>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = ids[t[i]], to = ids[t[(i + 1) % 3]];
      edges.emplace_back(std::min(from, to), std::max(from, to), from < to ? 1 : -1);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    const auto [from, to, first] = edges[i];
    int sum = 0;
    for (; i < edges.size() && std::get<0>(edges[i]) == from && std::get<1>(edges[i]) == to; ++i) {
      sum += std::get<2>(edges[i]);
    }
    if (sum != 0) return false;
  }
  return true;
}

double signed_volume(const Mesh& mesh) {
  if (mesh.positions.empty()) return 0.0;
  const glm::dvec3 origin(mesh.positions.front());  // far off, the sum would cancel
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto [a, b, c] = triangle_of(mesh, t, origin);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

double normals_along_winding(const Mesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto [a, b, c] = triangle_of(mesh, t, glm::dvec3(0.0));
    const glm::dvec3 normals = glm::dvec3(mesh.normals[t.x]) + glm::dvec3(mesh.normals[t.y]) +
                               glm::dvec3(mesh.normals[t.z]);
    sum += glm::dot(normals, glm::cross(b - a, c - a)) / 6.0;
  }
  return sum;
}

double winding_number(const Mesh& mesh, const glm::dvec3& point) {
  double solid_angle = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto [a, b, c] = triangle_of(mesh, t, point);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double below =
        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    solid_angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
  }
  return solid_angle / (4.0 * std::numbers::pi);
}

void flip_winding(Mesh& mesh) {
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
}

void flip_normals(Mesh& mesh) {
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
}

}  // namespace amalgam::scene
