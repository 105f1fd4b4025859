// Shadows of what textures, vertex colors and transforms make of a caster.
//
// Rays go straight up from beside the origin; make_floor's uv is (0.5 + x / 2, 0.5 + z / 2) for a
// half side of 1.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <tuple>

#include "trace/shadow.h"
#include "unit/trace/glass_meshes.h"
#include "unit/trace/halves_texture.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using scene::Role;
using test_support::add_object;
using test_support::make_floor;
using test_support::make_glass;

constexpr float kSurface = 0.96f;  // what n = 1.5 lets through, straight on
constexpr float kLeft = -0.5f, kRight = 0.5f;

ShadowAttenuation shadow_at(const scene::Scene& scene, float x) {
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  PassedSurfaces surfaces;
  return trace_shadow(embree, glm::dvec3(x, 0.01f, 0.2f), {{x, 0.01f, 0.2f}, {0, 1, 0}, kInfinity},
                      surfaces);
}

void expect_near(const glm::vec3& seen, const glm::vec3& expected, float tolerance = 1e-6f) {
  EXPECT_LT(glm::distance(seen, expected), tolerance)
      << seen.r << " " << seen.g << " " << seen.b << ", expected " << expected.r << " "
      << expected.g << " " << expected.b;
}

scene::Material thin_glass() {
  scene::Material material = make_glass(1.5f);
  material.thin = true;
  return material;
}
constexpr float kSheet = 1.0f - 2.0f * 0.04f / 1.04f;  // what thin glass lets through

TEST(ShadowTextures, OpaqueTexelsOfGlassBlockAndClearOnesPassItsColor) {
  scene::Scene scene;
  scene::Material material = thin_glass();
  material.base_color = {0.5f, 0.25f, 1.0f, 1.0f};
  material.transmission = 0.5f;
  material.transmission_texture = add_halves(scene, {0, 255, 255, 255}, {204, 0, 0, 255});
  add_object(scene, make_floor(1.0f, 1.0f), material, Role::Virtual);
  expect_near(shadow_at(scene, kLeft).mixed, glm::vec3(0.0f));
  expect_near(shadow_at(scene, kRight).mixed, kSheet * 0.5f * 0.8f * glm::vec3(0.5f, 0.25f, 1.0f));
  expect_near(shadow_at(scene, kRight).real, glm::vec3(1.0f));
}

// The window's colors fall on both solutions if it is real, and multiply if there are two.
TEST(ShadowTextures, ColoredPanesMultiply) {
  scene::Scene scene;
  scene::Material real = thin_glass(), added = thin_glass();
  real.base_color_texture = add_halves(scene, {255, 0, 0, 255}, {255, 255, 255, 255});
  added.base_color = {0.5f, 0.5f, 1.0f, 1.0f};
  add_object(scene, make_floor(1.0f, 1.0f), real, Role::Real);
  add_object(scene, make_floor(2.0f, 1.0f), added, Role::Virtual);
  expect_near(shadow_at(scene, kLeft).real, kSheet * glm::vec3(1, 0, 0));
  expect_near(shadow_at(scene, kLeft).mixed, kSheet * kSheet * glm::vec3(0.5f, 0, 0));
  expect_near(shadow_at(scene, kRight).real, kSheet * glm::vec3(1.0f));
  expect_near(shadow_at(scene, kRight).mixed, kSheet * kSheet * glm::vec3(0.5f, 0.5f, 1.0f));
}

// Alpha below the cut-off is a hole; at the cut-off the surface is there (glTF).
TEST(ShadowTextures, HolesOfAMaskLetLightThroughInEachSolution) {
  for (const auto& [role, mixed_left, real_left] :
       {std::tuple{Role::Virtual, 0.0f, 1.0f}, {Role::Real, 0.0f, 0.0f}}) {
    scene::Scene scene;
    scene::Material leaf = test_support::make_diffuse(glm::vec3(0.8f));
    leaf.base_color_texture = add_halves(scene, {90, 200, 10, 255}, {90, 200, 10, 101});
    leaf.alpha_cutoff = 0.4f;
    add_object(scene, make_floor(1.0f, 1.0f), leaf, role);
    expect_near(shadow_at(scene, kLeft).mixed, glm::vec3(mixed_left));
    expect_near(shadow_at(scene, kLeft).real, glm::vec3(real_left));
    EXPECT_EQ(shadow_at(scene, kRight).mixed, glm::vec3(1.0f));
    EXPECT_EQ(shadow_at(scene, kRight).real, glm::vec3(1.0f));
    scene.textures[0].texels.at(2, 0).a = scene.textures[0].texels.at(3, 0).a = 102;  // 0.4
    expect_near(shadow_at(scene, kRight).mixed, glm::vec3(0.0f));
  }
}

// A hole in a virtual leaf uncovers the real caster behind it, and the other way round.
TEST(ShadowTextures, MasksOfRealAndVirtualCastersAreApart) {
  scene::Scene scene;
  scene::Material left = test_support::make_diffuse(glm::vec3(0.8f)), right = left;
  left.base_color_texture = add_halves(scene, {9, 9, 9, 255}, {9, 9, 9, 0});
  right.base_color_texture = add_halves(scene, {9, 9, 9, 0}, {9, 9, 9, 255});
  left.alpha_cutoff = right.alpha_cutoff = 0.5f;
  add_object(scene, make_floor(1.0f, 1.0f), left, Role::Virtual);
  add_object(scene, make_floor(2.0f, 1.0f), right, Role::Real);
  expect_near(shadow_at(scene, kLeft).mixed, glm::vec3(0.0f));
  expect_near(shadow_at(scene, kLeft).real, glm::vec3(1.0f));
  expect_near(shadow_at(scene, kRight).mixed, glm::vec3(0.0f));
  expect_near(shadow_at(scene, kRight).real, glm::vec3(0.0f));
}

TEST(ShadowTextures, VertexAlphaIsMaskedToo) {
  scene::Scene scene;
  scene::Mesh mesh = make_floor(1.0f, 1.0f);
  mesh.colors = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};  // alpha = uv.x
  scene::Material material = test_support::make_diffuse(glm::vec3(0.8f));
  material.alpha_cutoff = 0.5f;
  add_object(scene, mesh, material, Role::Virtual);
  EXPECT_EQ(shadow_at(scene, kLeft).mixed, glm::vec3(1.0f));
  expect_near(shadow_at(scene, kRight).mixed, glm::vec3(0.0f));
}

// Casters have no side to be left out: what faces the light and what turns away from it, marked
// double-sided or not, block alike.
TEST(ShadowTextures, CastersBlockFromBothSides) {
  for (const bool double_sided : {false, true}) {
    for (const bool turned : {false, true}) {
      scene::Scene scene;
      scene::Material material = test_support::make_diffuse(glm::vec3(0.8f));
      material.double_sided = double_sided;
      const scene::Mesh sheet = make_floor(1.0f, 1.0f);
      add_object(scene, turned ? turned_inside_out(sheet) : sheet, material, Role::Real);
      expect_near(shadow_at(scene, kLeft).real, glm::vec3(0.0f));
    }
  }
}

// Absorption is a sum with signs, so it would become a gain if a mirrored solid were taken for one
// inside out.
TEST(ShadowTextures, MirroredGlassAbsorbsOverItsThickness) {
  const glm::vec3 absorption(1.0f, 2.0f, 5.0f);
  for (const float scale : {1.0f, -1.0f}) {
    scene::Scene scene;
    add_object(scene, test_support::make_box({-1, 1, -1}, {1, 1.2f, 1}),
               make_glass(1.5f, absorption), Role::Virtual,
               glm::scale(glm::mat4(1.0f), {scale, 2.0f, 1.0f}));
    expect_near(shadow_at(scene, kLeft).mixed, kSurface * kSurface * glm::exp(-0.4f * absorption),
                1e-5f);
  }
}

// A solid that is left and never entered, or entered and never left: no more than all the light.
TEST(ShadowTextures, OpenGlassNeverBrightens) {
  for (const bool turned : {false, true}) {
    scene::Scene scene;
    const scene::Mesh sheet = make_floor(1.0f, 1.0f);
    add_object(scene, turned ? turned_inside_out(sheet) : sheet, make_glass(1.5f, glm::vec3(3.0f)),
               Role::Virtual);
    const glm::vec3 mixed = shadow_at(scene, kLeft).mixed;
    // Seen from within, the 0.99 m from the start of the ray are glass.
    expect_near(mixed, glm::vec3(turned ? kSurface : kSurface * std::exp(-0.99f * 3.0f)));
  }
}

}  // namespace
}  // namespace amalgam::trace
