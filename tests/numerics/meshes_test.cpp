// numerics B21 and B23: pictures of broken meshes, and of meshes at all scales.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/flush_denormals.h"
#include "numerics/icosphere.h"
#include "scene/gltf/transform.h"
#include "scene/mesh_repair.h"
#include "scene/scene_error.h"
#include "support/compare_images.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

// The sky is brighter above, so that a ball's picture shows where its normals point.
scene::Environment gradient() {
  scene::Environment sky{common::ImageRgb32f(16, 8), false};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      sky.radiance.at(x, y) =
          glm::vec3(0.1f * static_cast<float>(9 - y), 0.02f * static_cast<float>(x), 0.3f);
    }
  }
  return sky;
}

common::ImageRgb32f picture_of(scene::Mesh mesh, const glm::mat4& place, double distance,
                               std::uint64_t* nonfinite = nullptr,
                               scene::Material material = test_support::make_glass()) {
  const scene::Environment sky = gradient();
  scene::Scene scene;
  add_object(scene, std::move(mesh), std::move(material), scene::Role::Virtual, place);
  TraceResult result = trace_shot(scene, {.eye = distance * glm::dvec3(0.3, 0.5, 2.5),
                                          .environment = &sky,
                                          .width = 40,
                                          .height = 40,
                                          .focal_length = 45});
  if (nonfinite != nullptr) *nonfinite = result.nonfinite;
  return result.images->mixed;
}

// Needles ever thinner, from the middle of a triangle's edge: dropped where their height is below
// 1e-10 of their length.
TEST(BadMeshes, NeedlesAreKeptDownToTheirLimit) {
  const auto is_kept = [](float height) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, height, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    const scene::MeshRepairs repairs = scene::repair_mesh(mesh);
    EXPECT_EQ(repairs.zero_area + mesh.triangles.size(), 1u);
    return !mesh.triangles.empty();
  };
  for (const float height : {1e-2f, 1e-6f, 1.1e-10f}) EXPECT_TRUE(is_kept(height)) << height;
  for (const float height : {0.9e-10f, 1e-20f, 0.0f}) EXPECT_FALSE(is_kept(height)) << height;
}

// As many bad triangles as good ones change nothing in the picture.
TEST(BadMeshes, LookLikeTheCleanedMesh) {
  scene::Mesh clean = test_support::make_icosphere(2);
  scene::repair_mesh(clean);  // normals to a length of 1
  scene::Mesh broken = clean;
  for (const glm::uvec3& t : clean.triangles) {
    broken.triangles.emplace_back(t.x, t.x, t.y);
    broken.positions.push_back(0.5f * (clean.positions[t.x] + clean.positions[t.y]));
    broken.normals.emplace_back(std::nanf(""));
    broken.triangles.emplace_back(t.x, static_cast<std::uint32_t>(broken.positions.size() - 1),
                                  t.x);
  }
  const scene::MeshRepairs repairs = scene::repair_mesh(broken);
  EXPECT_EQ(repairs.repeated_indices, 2 * clean.triangles.size());
  EXPECT_EQ(repairs.bad_normals, clean.triangles.size());
  EXPECT_TRUE(test_support::images_are_same("cleaned", picture_of(broken, glm::mat4(1.0f), 1.0),
                                            picture_of(clean, glm::mat4(1.0f), 1.0)));
}

scene::Mesh scaled(scene::Mesh mesh, const glm::vec3& by) {
  for (glm::vec3& p : mesh.positions) p *= by;
  for (glm::vec3& n : mesh.normals) n = glm::normalize(n / by);
  if (by.x * by.y * by.z < 0.0f) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  }
  return mesh;
}

// The same ball, camera and all made larger or smaller, by the transform or in the mesh. Frames are
// computed with denormals as zero.
TEST(Scales, LookTheSameOverAllAcceptedOnes) {
  const core::FlushDenormals flush;
  const scene::Mesh ball = test_support::make_icosphere(2);
  const common::ImageRgb32f expected = picture_of(ball, glm::mat4(1.0f), 1.0);
  const auto error = [&](const scene::Mesh& mesh, float place, double distance) {
    std::uint64_t nonfinite = 0;
    const auto actual =
        picture_of(mesh, glm::scale(glm::mat4(1.0f), glm::vec3(place)), distance, &nonfinite);
    EXPECT_EQ(nonfinite, 0u) << distance;
    return test_support::compare_images(actual, expected).maximum;
  };
  const auto by_transform = [&](double s) { return error(ball, static_cast<float>(s), s); };
  const auto by_mesh = [&](double s) {
    return error(scaled(ball, glm::vec3(static_cast<float>(s))), 1.0f, s);
  };
  for (const double scale : {1.1e-12, 1e-9, 1e-3, 1e3, 1e9, 1e11}) {
    EXPECT_NO_THROW(
        scene::check_transform_usable(glm::scale(glm::dmat4(1.0), glm::dvec3(scale)), "node"));
    EXPECT_LT(by_transform(scale), 1e-5) << scale;
  }
  for (const double scale : {1e-10, 1e-9, 1e-3, 1e3, 1e9, 1e11}) {
    EXPECT_LT(by_mesh(scale), 1e-5) << scale;
  }
  // Beyond: refused at load.
  for (const double scale : {0.9e-12, 1e-20, 1.1e11, 1e20}) {
    EXPECT_THROW(
        scene::check_transform_usable(glm::scale(glm::dmat4(1.0), glm::dvec3(scale)), "node"),
        scene::SceneError)
        << scale;
  }
  // Beyond, in the mesh: products of coordinates vanish in float, and rays go through.
  EXPECT_GT(by_mesh(1e-12), 0.1);
  EXPECT_GT(by_mesh(1e-20), 0.1);
}

// A mirror ball flattened or mirrored by its transform looks like one with such vertices, up to the
// condition number that is accepted. With normals of its triangles, because what lies between
// smooth ones depends on their lengths.
TEST(Scales, FlattenedBallsLookLikeFlattenedMeshes) {
  const core::FlushDenormals flush;
  scene::Mesh ball = test_support::make_icosphere(2);
  ball.normals.clear();
  scene::repair_mesh(ball);  // computes them
  for (const float flat : {1e-1f, -1e-2f, 1e-3f, -1e-4f, 1e-5f, 1e-6f}) {
    const glm::vec3 by(1.0f, flat, 1.0f);
    const auto compared = test_support::compare_images(
        picture_of(ball, glm::scale(glm::mat4(1.0f), by), 1.0, nullptr,
                   test_support::make_mirror()),
        picture_of(scaled(ball, by), glm::mat4(1.0f), 1.0, nullptr, test_support::make_mirror()));
    EXPECT_LT(compared.maximum, 1e-3) << flat << "\n" << compared.describe();
  }
  EXPECT_THROW(scene::check_transform_usable(glm::scale(glm::dmat4(1.0), {1.0, 0.9e-6, 1.0}), "n"),
               scene::SceneError);
}

}  // namespace
}  // namespace amalgam::trace
