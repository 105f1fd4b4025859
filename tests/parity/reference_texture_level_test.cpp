// The level of detail that a ray's cone asks for: log2(width / |cosine| in texels).
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"
#include "support/reference/pictures.h"

namespace amalgam::reference {
namespace {

using test_support::make_diffuse;
using test_support::make_floor;
using test_support::make_mirror;
using test_support::make_quad;
using test_support::make_sun;

// 4 x 4 white, 2 x 2 black, 1 x 1 white; alpha likewise. At level l in [0, 1] it reads 1 - l, in
// [1, 2] l - 1.
scene::Texture make_levels() {
  const common::Rgba8 white(255, 255, 255, 255), black(0, 0, 0, 0);
  scene::Texture texture;
  texture.texels = common::ImageRgba8(4, 4, white);
  texture.mips = {common::ImageRgba8(2, 2, black), common::ImageRgba8(1, 1, white)};
  return texture;
}

double value_at(double level) {
  return level <= 1.0 ? 1.0 - level : std::min(level, 2.0) - 1.0;
}

// A lamp of 2 x 2 m that shows the texture: half a metre a texel.
ClosedFormRig floor_of_levels() {
  scene::Material material = make_lamp();
  material.emissive_texture = 0;
  ClosedFormRig rig;
  rig.scene.textures.push_back(make_levels());
  rig.add(make_floor(0.0f, 1.0f), material);
  return rig;
}

TEST(ReferenceTextureLevel, FollowsTheFormula) {
  const scene::Texture texture = make_levels();
  EXPECT_EQ(level_of_detail(texture, 0.0), 0.0);
  EXPECT_EQ(level_of_detail(texture, 1.0 / 16.0), 0.0);
  EXPECT_NEAR(level_of_detail(texture, 1.0 / 8.0), 0.5, 1e-15);
  EXPECT_NEAR(level_of_detail(texture, 1.0 / 4.0), 1.0, 1e-15);
  EXPECT_EQ(level_of_detail(texture, 77.0), 2.0);
  scene::Texture full_size_only = texture;
  full_size_only.mips.clear();
  EXPECT_EQ(level_of_detail(full_size_only, 77.0), 0.0);
}

TEST(ReferenceTextureLevel, LevelsBlend) {
  const scene::Texture texture = make_levels();
  for (double level = 0.0; level < 2.5; level += 0.125) {
    const double uv_area = std::exp2(2.0 * level) / 16.0;
    const Vec4 texel = sample_texture(texture, TextureContent::Data, {0.3, 0.7}, uv_area);
    EXPECT_NEAR(texel.g, value_at(level), 1e-12) << level;
    EXPECT_NEAR(texel.a, value_at(level), 1e-12) << level;
  }
}

TEST(ReferenceTextureLevel, ConeWidensOnTheWayAndLiesSlanted) {
  const ClosedFormRig rig = floor_of_levels();
  for (const double height : {0.5, 1.0, 3.0}) {
    for (const double cosine : {1.0, 0.5}) {
      const Vec3 direction(std::sqrt(1.0 - cosine * cosine), -cosine, 0.0);
      const Vec3 origin = Vec3(0.1, 0.0, 0.2) - height / cosine * direction;
      const double width = 0.3 * height / cosine;
      const double level = std::max(0.0, std::log2(width / cosine / 0.5));
      EXPECT_NEAR(rig.trace(origin, direction, 0.3).mixed.g, value_at(level), 1e-12);
    }
  }
}

TEST(ReferenceTextureLevel, ConeGoesOnBehindAMirror) {
  ClosedFormRig rig = floor_of_levels();
  rig.add(make_quad({0.0f, 2.0f, 0.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 9.0f}), make_mirror());
  // Up 1 m, down 2 m.
  const double level = std::log2(0.25 * 3.0 / 0.5);
  EXPECT_NEAR(rig.trace({0.1, 1.0, 0.2}, {0.0, 1.0, 0.0}, 0.25).mixed.g, value_at(level), 1e-12);
}

// A sheet whose full size is there and whose halved size is not.
TEST(ReferenceTextureLevel, ShadowsReadTheFullSize) {
  ClosedFormRig rig;
  rig.scene.textures.push_back(make_levels());
  rig.add(make_floor(0.0f, 9.0f), make_diffuse(glm::vec3(1.0f)), scene::Role::Real);
  scene::Material leaf = make_lamp(glm::vec3(50.0f));
  leaf.base_color = glm::vec4(1.0f);
  leaf.base_color_texture = 0;
  leaf.alpha_cutoff = 0.5f;
  rig.add(make_floor(2.0f, 1.0f), leaf);
  rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
  const Vec3 origin(0.1, 4.0, 0.2), down(0.0, -1.0, 0.0);
  EXPECT_GT(rig.trace(origin, down, 0.0).mixed.g, 49.0);  // the leaf
  const Sample through = rig.trace(origin, down, 0.5);    // level 1: what lies below, in its shadow
  EXPECT_EQ(through.mixed, Color(0.0));
  EXPECT_NEAR(through.real.g, 3.0 / kPi, 1e-7);
}

}  // namespace
}  // namespace amalgam::reference
