// Scenes of nothing, of next to nothing, and of very much.
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "extreme/desk.h"
#include "support/scene_builders.h"

namespace amalgam::extreme {
namespace {

using namespace test_support;
using scene::Role;

// The desk's camera and light without anything on the desk.
parity::ParityCase empty_desk() {
  parity::ParityCase desk = make_desk();
  desk.scene.instances.clear();
  desk.scene.meshes.clear();
  desk.scene.materials.clear();
  return desk;
}

TEST(ExtremeScene, OfNoObjectChangesNothing) {
  const parity::ParityCase desk = empty_desk();
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    EXPECT_TRUE(render(desk, mode).composite == desk.camera_image);
  }
}

scene::Mesh one_triangle() {
  scene::Mesh mesh = make_quad({0.0f, 0.1f, 0.0f}, {0.3f, 0.0f, 0.0f}, {0.0f, 0.2f, -0.1f});
  mesh.triangles.resize(1);
  return mesh;
}

TEST(ExtremeScene, OfOneTriangle) {
  for (const scene::Material& material :
       {make_diffuse({0.7f, 0.4f, 0.2f}), make_mirror(), make_glass(1.5f)}) {
    parity::ParityCase desk = empty_desk();
    add_object(desk.scene, one_triangle(), material, Role::Virtual);
    desk.name = "one triangle, " + material.name;
    expect_right(desk);
  }
}

// 100 x 100 small blocks: real and virtual, diffuse, mirrors and glass by turns.
TEST(ExtremeScene, OfTenThousandObjects) {
  parity::ParityCase desk = empty_desk();
  add_object(desk.scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.6f)), Role::Real);
  constexpr int kSide = 100;
  for (int i = 0; i < kSide * kSide; ++i) {
    const auto x = static_cast<float>(i % kSide), z = static_cast<float>(i / kSide);
    const glm::vec3 at(0.01f * (x - 50.0f), 0.002f + 0.0002f * z, 0.01f * (z - 60.0f));
    const scene::Material material = i % 5 == 0   ? make_mirror(glm::vec3(0.9f))
                                     : i % 7 == 0 ? make_glass(1.5f)
                                                  : make_diffuse({0.2f, 0.5f, 0.1f});
    add_object(desk.scene, make_box(glm::vec3(-0.003f), glm::vec3(0.003f)), material,
               i % 3 == 0 ? Role::Real : Role::Virtual,
               glm::translate(glm::mat4(1.0f), at + glm::vec3(0.0f, 0.003f, 0.0f)));
  }
  desk.name = "ten thousand objects";
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    const parity::Rendering picture = render(desk, mode);
    EXPECT_EQ(picture.statistics.nonfinite, 0u);
    EXPECT_GT(picture.statistics.pixels.virtual_pixels, 300u);
  }
}

// A glass ball of two million triangles is as round as can be: the picture is that of a ball that
// the reference meets by its equation.
TEST(ExtremeScene, OfTwoMillionTriangles) {
  if (std::getenv("AMALGAM_LONG_TESTS") == nullptr)
    GTEST_SKIP() << "takes half a minute: AMALGAM_LONG_TESTS=1 runs it";
  parity::ParityCase desk = empty_desk();
  add_object(desk.scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.6f)), Role::Real);
  constexpr float kRadius = 0.2f;
  const scene::Material glass = make_glass(1.5f);
  reference::ReferenceRequest request = parity::make_reference_request(desk);
  request.find_grazing = true;
  reference::Geometry geometry = reference::make_geometry(desk.scene, request.anchored);
  geometry.balls.push_back({{0.0, 0.25, 0.0}, double{kRadius}, 1});
  geometry.objects.push_back({glass, 1, Role::Virtual, 0.0});
  const reference::World world(std::move(geometry), {});
  const auto expected =
      reference::render_reference(world, &desk.scene.environment.value(), request);

  add_object(desk.scene, make_sphere({0.0f, 0.25f, 0.0f}, kRadius, 1000, 1001), glass,
             Role::Virtual);
  ASSERT_EQ(desk.scene.meshes.back().triangles.size(), 2'000'000u);
  desk.name = "two million triangles";
  expect_close(desk, expected);
}

}  // namespace
}  // namespace amalgam::extreme
