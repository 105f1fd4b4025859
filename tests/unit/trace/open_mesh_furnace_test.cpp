// numerics B9 for surfaces that are open where glass should be closed, and for media that do not
// nest: in a furnace of radiance 1 every pixel shows 1.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "unit/trace/furnace.h"
#include "unit/trace/glass_meshes.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_box;
using test_support::make_glass;
using test_support::make_quad;
using test_support::make_sphere;

scene::Mesh random_triangles(std::mt19937& random, int count, float size) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  scene::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<unsigned>(mesh.positions.size());
    const glm::vec3 centre = vector();
    const glm::vec3 a = centre + size * vector(), b = centre + size * vector(),
                    c = centre + size * vector();
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3& corner : {a, b, c}) {
      mesh.positions.push_back(corner);
      // Smooth normals that lean, as those of a real mesh do.
      mesh.normals.push_back(glm::normalize(normal + 0.5f * vector()));
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

TEST(OpenMeshFurnace, ASphereWithHoles) {
  for (const std::size_t missing : {2u, 3u, 7u, 50u}) {
    scene::Scene scene;
    add_object(scene, with_holes(make_sphere(glm::vec3(0.0f), 1.0f, 24, 12), missing), make_glass(),
               scene::Role::Virtual);
    expect_furnace(scene);
  }
}

TEST(OpenMeshFurnace, HalfABoxFacingEitherWay) {
  scene::Mesh half = make_box(glm::vec3(-0.7f), glm::vec3(0.7f));
  half.triangles.resize(half.triangles.size() / 2);
  for (const scene::Mesh& mesh : {half, turned_inside_out(half)}) {
    scene::Scene scene;
    add_object(scene, mesh, make_glass(), scene::Role::Virtual);
    expect_furnace(scene);
  }
}

TEST(OpenMeshFurnace, ASingleSheetOfSolidGlass) {
  const scene::Mesh sheet = make_quad(glm::vec3(0.0f), {1.0f, 0.3f, 0}, {0, 0.6f, 0.8f});
  scene::Mesh triangle = sheet;
  triangle.triangles.resize(1);
  for (const scene::Mesh& mesh : {sheet, triangle, turned_inside_out(sheet)}) {
    scene::Scene scene;
    add_object(scene, mesh, make_glass(2.4f), scene::Role::Virtual);
    expect_furnace(scene);
  }
}

// Sheets that all face the same way: a ray enters again and again and never leaves, or leaves what
// it never entered, more often than the media that it carries.
TEST(OpenMeshFurnace, MediaThatAreOnlyEnteredOrOnlyLeft) {
  for (const float side : {1.0f, -1.0f}) {
    scene::Scene scene;
    for (int i = 0; i < 12; ++i) {
      add_object(scene,
                 make_quad({0, 0, 0.1f * static_cast<float>(i)}, {side, 0, 0.05f}, {0, 1, 0.1f}),
                 make_glass(1.1f + 0.1f * static_cast<float>(i % 7)), scene::Role::Virtual);
    }
    expect_furnace(scene);
  }
}

TEST(OpenMeshFurnace, NestedDeeperThanTheMediaThatARayCarries) {
  scene::Scene scene;
  for (int i = 0; i < 9; ++i) {
    add_object(scene,
               make_sphere(glm::vec3(0.01f * static_cast<float>(i)),
                           1.0f - 0.1f * static_cast<float>(i), 16, 8),
               make_glass(i % 2 == 0 ? 1.5f : 1.0f + 0.1f * static_cast<float>(i)),
               scene::Role::Virtual);
  }
  expect_furnace(scene);
}

// Overlaps that nest in no order, faces that coincide, and a solid inside out around them.
TEST(OpenMeshFurnace, SolidsThatOverlapAndTouch) {
  scene::Scene scene;
  const scene::Mesh box = make_box(glm::vec3(-0.5f), glm::vec3(0.5f));
  add_object(scene, box, make_glass(), scene::Role::Virtual);
  add_object(scene, box, make_glass(1.33f), scene::Role::Virtual);
  add_object(scene, turned_inside_out(box), make_glass(1.2f), scene::Role::Virtual);
  add_object(scene, make_box({0.5f, -0.5f, -0.5f}, {0.9f, 0.5f, 0.5f}), make_glass(1.8f),
             scene::Role::Virtual);
  add_object(scene, make_sphere({0.4f, 0.3f, 0.2f}, 0.6f, 20, 10), make_glass(1.33f),
             scene::Role::Virtual);
  add_object(scene, make_sphere({-0.2f, 0.1f, 0.0f}, 0.7f, 20, 10), make_glass(2.4f),
             scene::Role::Virtual);
  expect_furnace(scene);
}

TEST(OpenMeshFurnace, SoupsOfGlassAndMirrors) {
  std::mt19937 random(11);
  for (const float size : {0.05f, 0.4f, 2.0f}) {
    scene::Scene scene;
    for (const float index : {1.0f, 1.0001f, 1.33f, 1.5f, 4.0f}) {
      add_object(scene, random_triangles(random, 60, size), make_glass(index),
                 scene::Role::Virtual);
    }
    scene::Material thin = make_glass();
    thin.thin = true;
    add_object(scene, random_triangles(random, 60, size), thin, scene::Role::Virtual);
    add_object(scene, random_triangles(random, 60, size), test_support::make_mirror(),
               scene::Role::Virtual);
    expect_furnace(scene);
  }
}

// Indices and absorptions at the ends of float, seen from a corner, from on a face and along it:
// no gain, and no numbers that are none.
TEST(OpenMeshFurnace, ExtremeMaterialsStayWithinIt) {
  const scene::Environment furnace = constant_environment(1.0f);
  for (const float index : {1.0f, 1.0000001f, 1e4f, 3e38f}) {
    for (const float absorption : {0.0f, 1e-38f, 1e4f, 3e38f}) {
      scene::Scene scene;
      add_object(scene, make_box(glm::vec3(-0.5f), glm::vec3(0.5f)),
                 make_glass(index, glm::vec3(absorption)), scene::Role::Virtual);
      for (const glm::dvec3& eye : {glm::dvec3(0.5), glm::dvec3(0.1, 0.2, 0.5),
                                    glm::dvec3(0.1, 2.0, 0.5), glm::dvec3(0.1, 0.2, 3.0)}) {
        const TraceResult result = trace_shot(
            scene,
            {.eye = eye, .environment = &furnace, .width = 15, .height = 15, .focal_length = 10});
        ASSERT_EQ(result.nonfinite, 0u) << index << " " << absorption;
        for (const glm::vec3& pixel : result.images->mixed.pixels())
          ASSERT_TRUE(pixel.x >= 0.0f && pixel.x <= 1.0f + kFurnaceBound)
              << index << " " << absorption;
      }
    }
  }
}

}  // namespace
}  // namespace amalgam::trace
