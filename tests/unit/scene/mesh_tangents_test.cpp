#include "scene/mesh_tangents.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amalgam::scene {
namespace {

// A unit square in the xy plane that faces +Z, painted the right way up: v points down.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(MeshTangents, PointAlongUAndTellTheHandedness) {
  Mesh mesh = square();
  complete_tangents(mesh, false);
  ASSERT_EQ(mesh.tangents.size(), 4u);
  for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));

  Mesh mirrored = square();
  for (glm::vec2& uv : mirrored.uvs) uv.x = -uv.x;
  complete_tangents(mirrored, false);
  for (const glm::vec4& tangent : mirrored.tangents) EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(MeshTangents, VerticesSharedByMirroredTrianglesAreSplit) {
  Mesh mesh = square();
  mesh.uvs[3] = {1.5f, 0.5f};  // folds the second triangle over the first
  complete_tangents(mesh, false);
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.tangents.size(), 6u);
  EXPECT_EQ(mesh.uvs.size(), 6u);
  for (int corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(mesh.tangents[mesh.triangles[0][corner]].w, 1.0f);
    EXPECT_EQ(mesh.tangents[mesh.triangles[1][corner]].w, -1.0f);
  }
}

TEST(MeshTangents, GivenOnesAreKeptAndCleaned) {
  Mesh mesh = square();
  mesh.tangents = {{0, 2, 0, -1}, {0, 0, 0, 1}, {NAN, 0, 0, 1}, {0, 1, 0, 0.9f}};
  complete_tangents(mesh, false);
  EXPECT_EQ(mesh.tangents[0], glm::vec4(0, 1, 0, -1));
  EXPECT_EQ(glm::vec3(mesh.tangents[1]), glm::vec3(0.0f));
  EXPECT_EQ(glm::vec3(mesh.tangents[2]), glm::vec3(0.0f));
  EXPECT_EQ(mesh.tangents[3].w, 1.0f);
}

TEST(MeshTangents, NoneWithoutCoordinates) {
  Mesh mesh = square();
  complete_tangents(mesh, true);
  EXPECT_TRUE(mesh.tangents.empty());
  mesh.uvs.assign(4, glm::vec2(0.5f));  // no area
  complete_tangents(mesh, false);
  for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(glm::vec3(tangent), glm::vec3(0.0f));
}

}  // namespace
}  // namespace amalgam::scene
