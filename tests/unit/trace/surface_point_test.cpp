#include "trace/surface_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "support/scene_builders.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

TEST(SurfacePoint, NormalsFaceTheRayAndFrontIsOutside) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1.0f), test_support::make_mirror(),
             scene::Role::Virtual);
  EmbreeScene embree(scene);
  scene::AnchoredScene anchored;
  anchored.instances = {{0, glm::mat4(1.0f)}};
  embree.place(anchored);
  for (const float side : {1.0f, -1.0f}) {
    const glm::vec3 direction(0.0f, -side, 0.0f);
    const auto hit = embree.intersect({{0.2f, side, 0.3f}, direction, 10.0f}, Visible::Everything);
    ASSERT_TRUE(hit);
    const SurfacePoint point = surface_point(embree, *hit, direction);
    EXPECT_EQ(point.front, side > 0.0f);
    EXPECT_EQ(point.geometric_normal, glm::dvec3(0, side, 0));
    EXPECT_EQ(point.shading_normal, glm::dvec3(0, side, 0));
    EXPECT_NEAR(glm::distance(point.position, glm::dvec3(0.2, 0.0, 0.3)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(point.inside, point.position), 0.0, 2e-6);
  }
}

// numerics B23: outside stays outside under mirroring, and normals stay upright under uneven
// scales.
TEST(SurfacePoint, MirroredAndStretchedInstancesKeepTheirOutside) {
  scene::Scene scene;
  const glm::mat4 stretch = glm::scale(glm::mat4(1.0f), glm::vec3(-2.0f, 0.5f, 1.0f));
  add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 1.0f, 64, 64),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual, stretch);
  EmbreeScene embree(scene);
  scene::AnchoredScene anchored;
  anchored.instances = {{0, stretch}};
  embree.place(anchored);
  const glm::vec3 direction(0.0f, -1.0f, 0.0f);
  const auto hit = embree.intersect({{1.0f, 3.0f, 0.1f}, direction, 10.0f}, Visible::Everything);
  ASSERT_TRUE(hit);
  const SurfacePoint point = surface_point(embree, *hit, direction);
  EXPECT_TRUE(point.front);
  // Gradient of (x/2)^2 + (y/0.5)^2 + z^2.
  const glm::dvec3 p = point.position;
  const glm::dvec3 expected = glm::normalize(glm::dvec3(p.x / 4.0, p.y / 0.25, p.z));
  EXPECT_GT(glm::dot(point.shading_normal, expected), 0.999);
}

// A normal texture that leans along v bends a mirrored surface as its mirror image bends.
TEST(SurfacePoint, NormalTexturesBendMirroredSurfacesAsTheirMirrorImage) {
  scene::Scene scene;
  scene::Texture texture;
  texture.texels = common::ImageRgba8(1, 1, {128, 255, 128, 255});
  scene.textures.push_back(texture);
  scene::Mesh quad = test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0});
  quad.tangents.assign(quad.positions.size(), glm::vec4(1, 0, 0, 1));
  scene::Material material = test_support::make_mirror();
  material.normal_texture = 0;
  const glm::vec3 direction(0.0f, 0.0f, -1.0f);
  const auto bent = [&](const glm::mat4& place) {
    scene::Scene placed = scene;
    add_object(placed, quad, material, scene::Role::Virtual, place);
    EmbreeScene embree(placed);
    scene::AnchoredScene anchored;
    anchored.instances = {{0, place}};
    embree.place(anchored);
    const auto hit = embree.intersect({{0.2f, 0.1f, 1.0f}, direction, 10.0f}, Visible::Everything);
    return surface_point(embree, hit.value(), direction).shading_normal;
  };
  const glm::dvec3 plain = bent(glm::mat4(1.0f));
  EXPECT_GT(plain.y, 0.5);
  for (const glm::vec3& mirror : {glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1)}) {
    const glm::dvec3 expected = glm::dvec3(mirror) * plain;
    const glm::dvec3 mirrored = bent(glm::scale(glm::mat4(1.0f), mirror));
    EXPECT_LT(glm::distance(mirrored, expected), 1e-6) << mirror.x << " " << mirror.y;
  }
}

// numerics B10: for any view above the surface the reflection ends above it too.
TEST(ValidShadingNormal, KeepsReflectionsAboveTheSurface) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
  };
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec3 geometric = direction();
    glm::dvec3 view = direction(), shading = direction();
    if (glm::dot(view, geometric) < 0.0) view = -view;
    if (glm::dot(view, geometric) < 1e-6) continue;
    if (glm::dot(shading, geometric) < 0.0) shading = -shading;
    const glm::dvec3 bent = valid_shading_normal(geometric, shading, view);
    ASSERT_NEAR(glm::length(bent), 1.0, 1e-9);
    ASSERT_GT(glm::dot(bent, view), 0.0);
    const glm::dvec3 reflected = 2.0 * glm::dot(bent, view) * bent - view;
    ASSERT_GT(glm::dot(reflected, geometric), 0.0)
        << glm::dot(view, geometric) << " " << glm::dot(shading, view);
  }
}

TEST(ValidRefraction, GoesBelowTheSurfaceAndLeavesGoodRaysAlone) {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 good = glm::normalize(glm::dvec3(1, -1e-4, 0));
  EXPECT_EQ(valid_refraction(up, good), good);
  for (const double height : {-1e-6, 0.0, 1e-3, 0.4}) {
    const glm::dvec3 bent = valid_refraction(up, glm::normalize(glm::dvec3(0.6, height, 0.8)));
    EXPECT_NEAR(bent.y, -1e-5, 1e-6) << height;
    EXPECT_NEAR(glm::length(bent), 1.0, 1e-12) << height;
    EXPECT_NEAR(bent.x, 0.6, 1e-9) << height;
  }
}

TEST(ValidShadingNormal, LeavesGoodNormalsAlone) {
  const glm::dvec3 shading = glm::normalize(glm::dvec3(0.1, 1.0, 0.0));
  EXPECT_EQ(valid_shading_normal({0, 1, 0}, shading, {0, 1, 0}), shading);
}

}  // namespace
}  // namespace amalgam::trace
