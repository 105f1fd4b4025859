#include "scene/texture_lookup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/light/tone_map.h"
#include "scene/mip_chain.h"

namespace amalgam::scene {
namespace {

common::ImageRgba8 checks(int width, int height) {
  common::ImageRgba8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<std::uint8_t>((x + y) % 2 == 0 ? 255 : 0);
      image.at(x, y) = {value, value, value, value};
    }
  }
  return image;
}

TEST(MipChain, HalvesDownToOneTexel) {
  const auto mips = make_mips(checks(12, 5), TexelEncoding::Srgb);
  ASSERT_EQ(mips.size(), 3u);
  EXPECT_EQ(mips[0].size(), glm::ivec2(6, 2));
  EXPECT_EQ(mips[1].size(), glm::ivec2(3, 1));
  EXPECT_EQ(mips[2].size(), glm::ivec2(1, 1));
  EXPECT_TRUE(make_mips(checks(1, 1), TexelEncoding::Srgb).empty());
}

TEST(MipChain, MeansAreTakenInLinearLight) {
  const common::Rgba8 color = make_mips(checks(2, 2), TexelEncoding::Srgb).at(0).at(0, 0);
  EXPECT_EQ(color.x, srgb_encode(0.5f));  // 188 and not 128
  EXPECT_EQ(color.w, 128);                // alpha is linear
  EXPECT_EQ(make_mips(checks(2, 2), TexelEncoding::Linear).at(0).at(0, 0).x, 128);
}

TEST(MipChain, OddSizesCountEveryTexelByItsArea) {
  common::ImageRgba8 image(5, 1);
  image.at(2, 0) = {250, 0, 0, 0};  // a half belongs to each of the two texels of 2.5
  const auto mips = make_mips(image, TexelEncoding::Linear);
  EXPECT_EQ(mips.at(0).at(0, 0).x, 50);
  EXPECT_EQ(mips.at(0).at(1, 0).x, 50);
  EXPECT_EQ(mips.at(1).at(0, 0).x, 50);
}

Texture mipped(common::ImageRgba8 texels) {
  Texture texture{.texels = std::move(texels), .mips = {}};
  texture.mips = make_mips(texture.texels, TexelEncoding::Linear);
  return texture;
}

TEST(TextureLookup, OneTexelAPixelReadsTheFullSize) {
  const Texture texture = mipped(checks(8, 8));
  const glm::vec2 centre(2.5f / 8.0f, 3.5f / 8.0f);
  EXPECT_EQ(sample_data_texture(texture, centre, 0.0f).x, 0.0f);
  EXPECT_EQ(sample_data_texture(texture, centre, 1.0f / 64.0f).x, 0.0f);
}

// Texels 0 1 2 go on as 0 1 2 0 1, as 2 1 0 0 1, or as 2 2, and likewise to the left.
TEST(TextureLookup, WrapsRepeatMirrorOrEnd) {
  Texture texture{.texels = common::ImageRgba8(3, 1), .mips = {}};
  for (int x = 0; x < 3; ++x) texture.texels.at(x, 0).x = static_cast<std::uint8_t>(x);
  const auto row = [&](Wrap wrap) {
    texture.wrap_u = wrap;
    std::vector<int> values;
    for (int x = -4; x <= 7; ++x) {
      const glm::vec2 at((static_cast<float>(x) + 0.5f) / 3.0f, 0.5f);
      values.push_back(static_cast<int>(std::lround(255.0f * sample_data_texture(texture, at).x)));
    }
    return values;
  };
  EXPECT_EQ(row(Wrap::Repeat), (std::vector{2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1}));
  EXPECT_EQ(row(Wrap::Mirror), (std::vector{2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1}));
  EXPECT_EQ(row(Wrap::Clamp), (std::vector{0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2}));
}

TEST(TextureLookup, LevelsAreMixedByTheLogarithmOfTheFootprint) {
  Texture texture = mipped(checks(4, 4));
  texture.mips[0] = common::ImageRgba8(2, 2, {100, 0, 0, 255});
  texture.mips[1] = common::ImageRgba8(1, 1, {200, 0, 0, 255});
  const auto red = [&](float lod) {
    const float side = std::exp2(lod) / 4.0f;
    return 255.0f * sample_data_texture(texture, {0.3f, 0.6f}, side * side).x;
  };
  EXPECT_NEAR(red(1.0f), 100.0f, 1e-3f);
  EXPECT_NEAR(red(1.25f), 125.0f, 1e-3f);
  EXPECT_NEAR(red(2.0f), 200.0f, 1e-3f);
  EXPECT_NEAR(red(9.0f), 200.0f, 1e-3f);
}

TEST(TextureLookup, ColorsAreDecodedAndDataIsNot) {
  const Texture texture{.texels = common::ImageRgba8(1, 1, {188, 188, 188, 64}), .mips = {}};
  EXPECT_NEAR(sample_color_texture(texture, {0.5f, 0.5f}).x, 0.5f, 0.005f);
  EXPECT_EQ(sample_data_texture(texture, {0.5f, 0.5f}).x, 188.0f / 255.0f);
  EXPECT_EQ(sample_color_texture(texture, {0.5f, 0.5f}).w, 64.0f / 255.0f);
}

// A triangle of 2 m^2 over half of the uv square, seen by a cone 1 cm wide at 60 degrees: the cone
// covers (0.02 m)^2, a quarter of that in uv.
TEST(TextureLookup, FootprintsComeFromTheCone) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  const float ratio = uv_area_ratio(mesh, mesh.uvs, {0, 1, 2});
  EXPECT_NEAR(ratio, 0.25f, 1e-6f);
  EXPECT_NEAR(uv_footprint(ratio, 0.01f, -0.5f), 1e-4f, 1e-9f);
  EXPECT_EQ(uv_area_ratio(mesh, mesh.second_uvs, {0, 1, 2}), 0.0f);
  EXPECT_TRUE(std::isfinite(uv_footprint(ratio, 0.01f, 0.0f)));
}

}  // namespace
}  // namespace amalgam::scene
