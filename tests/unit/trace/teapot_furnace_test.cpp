// The Utah teapot of glass: its surfaces have no thickness, its lid, handle and spout stick into
// the body, and it is open at the spout.
#include <gtest/gtest.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>
#include <string>

#include "scene/mesh_repair.h"
#include "support/test_data.h"
#include "unit/trace/furnace.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

// Positions and triangles; smooth normals.
scene::Mesh read_obj(const std::filesystem::path& path) {
  scene::Mesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::vec3& p = mesh.positions.emplace_back();
      words >> p.x >> p.y >> p.z;
    } else if (kind == "f") {
      glm::uvec3& corners = mesh.triangles.emplace_back();
      words >> corners.x >> corners.y >> corners.z;
      corners -= 1u;
    }
  }
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
  scene::repair_mesh(mesh);  // computes them
  return mesh;
}

TEST(OpenMeshFurnace, TheUtahTeapot) {
  const auto data = tests::test_data();
  if (!data || !std::filesystem::exists(*data / "meshes/teapot.obj")) {
    GTEST_SKIP() << "no test data here (AMALGAM_TEST_DATA)";
  }
  const glm::mat4 two_metres =
      glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(0.33f)), glm::vec3(0.0f, -1.5f, 0.0f));
  scene::Scene scene;
  test_support::add_object(scene, read_obj(*data / "meshes/teapot.obj"), test_support::make_glass(),
                           scene::Role::Virtual, two_metres);
  ASSERT_GT(scene.meshes[0].triangles.size(), 6000u);
  expect_furnace(scene);
}

}  // namespace
}  // namespace amalgam::trace
