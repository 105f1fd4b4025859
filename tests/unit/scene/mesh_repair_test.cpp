#include "scene/mesh_repair.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

namespace amalgam::scene {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals = std::vector<glm::vec3>(4, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(MeshRepair, ACleanMeshIsLeftAlone) {
  Mesh mesh = square();
  const MeshRepairs repairs = repair_mesh(mesh);
  EXPECT_FALSE(repairs.any());
  EXPECT_EQ(repairs.describe(), "");
  EXPECT_EQ(mesh.positions, square().positions);
  EXPECT_EQ(mesh.triangles, square().triangles);
}

// numerics B21.
TEST(MeshRepair, TrianglesWithoutAreaAreDroppedAndCounted) {
  Mesh mesh = square();
  mesh.positions.push_back({0.5f, 0, 0});  // on the edge 0 1
  mesh.positions.push_back({0, 0, 0});     // a copy of vertex 0
  mesh.normals.resize(6, {0, 0, 1});
  mesh.uvs.resize(6);
  mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 1}, {0, 4, 1}, {0, 5, 2}, {2, 3, 2}});
  const MeshRepairs repairs = repair_mesh(mesh);
  EXPECT_EQ(repairs.repeated_indices, 2u);
  EXPECT_EQ(repairs.zero_area, 2u);
  EXPECT_EQ(mesh.triangles, square().triangles);
}

TEST(MeshRepair, SmallTrianglesAreKept) {
  Mesh mesh = square();
  for (glm::vec3& p : mesh.positions) p *= 1e-15f;
  EXPECT_FALSE(repair_mesh(mesh).any());
  Mesh thin = square();
  for (glm::vec3& p : thin.positions) p.y *= 1e-6f;
  EXPECT_FALSE(repair_mesh(thin).any());
}

TEST(MeshRepair, UnusableNormalsComeFromTheTriangles) {
  Mesh mesh = square();
  mesh.normals[0] = glm::vec3(kNan);
  mesh.normals[1] = glm::vec3(0.0f);
  mesh.normals[2] = glm::vec3(0, std::numeric_limits<float>::infinity(), 0);
  const MeshRepairs repairs = repair_mesh(mesh);
  EXPECT_EQ(repairs.bad_normals, 3u);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(MeshRepair, NormalsAreBroughtToLengthOne) {
  Mesh mesh = square();
  mesh.normals[3] = {0, 0, 5};
  mesh.normals[2] = {0, 0, 1.0001f};
  EXPECT_EQ(repair_mesh(mesh).scaled_normals, 1u);
  for (const glm::vec3& normal : mesh.normals) EXPECT_FLOAT_EQ(glm::length(normal), 1.0f);
}

TEST(MeshRepair, FlatNormalsSplitTheVertices) {
  Mesh mesh = square();
  mesh.normals.clear();
  mesh.positions[3] = {0, 1, 1};
  const MeshRepairs repairs = repair_mesh(mesh);
  EXPECT_TRUE(repairs.computed_normals);
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.normals.size(), 6u);
  EXPECT_EQ(mesh.uvs.size(), 6u);
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  for (int corner = 0; corner < 3; ++corner) {
    const glm::uvec3 t = mesh.triangles[1];
    EXPECT_NEAR(glm::length(mesh.normals[t[corner]]), 1.0f, 1e-6f);
  }
  EXPECT_NE(mesh.normals[3], mesh.normals[0]);
}

}  // namespace
}  // namespace amalgam::scene
