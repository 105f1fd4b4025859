#include "numerics/icosphere.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

namespace amalgam::test_support {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

scene::Mesh icosahedron() {
  constexpr float kGolden = std::numbers::phi_v<float>;
  scene::Mesh mesh;
  for (const float a : {-1.0f, 1.0f}) {
    for (const float b : {-kGolden, kGolden}) {
      mesh.positions.insert(mesh.positions.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    }
  }
  // Each three corners at the least distance from each other, 2, are a face.
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const auto adjacent = [&](std::uint32_t i, std::uint32_t j) {
    return glm::distance(mesh.positions[i], mesh.positions[j]) < 2.1f;
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = i + 1; j < count; ++j) {
      for (std::uint32_t k = j + 1; k < count; ++k) {
        if (!adjacent(i, j) || !adjacent(j, k) || !adjacent(k, i)) continue;
        const glm::vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
        const bool outwards = glm::dot(glm::cross(b - a, c - a), a) > 0.0f;
        mesh.triangles.emplace_back(i, outwards ? j : k, outwards ? k : j);
      }
    }
  }
  return mesh;
}

}  // namespace

scene::Mesh make_icosphere(int subdivisions) {
  scene::Mesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) {
    std::map<Edge, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return found->second;
    };
    std::vector<glm::uvec3> finer;
    for (glm::vec3& p : mesh.positions) p = glm::normalize(p);
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::vec3& p : mesh.positions) p = glm::normalize(p);
  mesh.normals = mesh.positions;
  return mesh;
}

}  // namespace amalgam::test_support
