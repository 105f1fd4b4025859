#include "scene/gltf/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

// The sample with two textures of one picture, and its material replaced by the given JSON.
Scene scene_of(const std::string& material, const std::string& more_attributes = "") {
  std::filesystem::copy_file(AMALGAM_SOURCE_DIR "/deploy/scenes/marble.png",
                             test_folder() / "marble.png",
                             std::filesystem::copy_options::overwrite_existing);
  std::string text = replaced(
      sample_gltf(),
      R"({"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0}})",
      material);
  text = replaced(text, R"("TEXCOORD_0": 2)", R"("TEXCOORD_0": 2)" + more_attributes);
  text = replaced(text, R"("accessors")",
                  R"("images": [{"uri": "marble.png"}], "textures": [{"source": 0}, {"source": 0}],
                     "accessors")");
  return load_text(text);
}

TEST(GltfTextures, EverySlotIsRead) {
  const Scene scene = scene_of(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
      "normalTexture": {"index": 0, "scale": 0.5},
      "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}}})");
  const Material& material = scene.materials.at(0);
  for (const TextureSlot slot : kAllTextureSlots) {
    EXPECT_EQ(material.texture(slot).has_value(), slot != TextureSlot::Transmission);
  }
  EXPECT_EQ(material.normal_scale, 0.5f);
  // One picture, as color and as data, the latter under two names.
  EXPECT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(material.base_color_texture, material.emissive_texture);
  EXPECT_EQ(material.normal_texture, material.metallic_roughness_texture);
  EXPECT_NE(material.normal_texture, material.base_color_texture);
  EXPECT_EQ(scene.textures[0].mips.size(), 7u);  // 128 texels
  EXPECT_EQ(scene.meshes[0].tangents.size(), scene.meshes[0].positions.size());
}

// Roughness matters for what glass does not let through.
TEST(GltfTextures, OnlyGlassThatScattersHasARoughness) {
  const auto glass_of = [](const std::string& transmission) {
    return scene_of(R"({"pbrMetallicRoughness":
      {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}},
      "extensions": {"KHR_materials_transmission": {)" +
                    transmission + "}}}");
  };
  const Scene clear = glass_of(R"("transmissionFactor": 1)");
  EXPECT_TRUE(clear.materials.at(0).base_color_texture);
  EXPECT_FALSE(clear.materials.at(0).metallic_roughness_texture);
  EXPECT_EQ(clear.textures.size(), 1u);
  const Scene hazy = glass_of(R"("transmissionFactor": 0.75)");
  EXPECT_EQ(hazy.materials.at(0).transmission, 0.75f);
  EXPECT_TRUE(hazy.materials.at(0).metallic_roughness_texture);
  const Scene painted = glass_of(R"("transmissionFactor": 1, "transmissionTexture": {"index": 1})");
  EXPECT_TRUE(painted.materials.at(0).transmission_texture);
  EXPECT_TRUE(painted.materials.at(0).metallic_roughness_texture);
}

TEST(GltfTextures, WhatNothingReadsIsNotLoaded) {
  const Scene black = scene_of(R"({"emissiveTexture": {"index": 0}})");
  EXPECT_TRUE(black.textures.empty());
  EXPECT_TRUE(black.meshes[0].tangents.empty());
  const Scene mirror = scene_of(R"({"pbrMetallicRoughness":
      {"roughnessFactor": 0, "metallicRoughnessTexture": {"index": 0}}})");
  EXPECT_EQ(mirror.materials[0].kind, MaterialKind::Mirror);
  EXPECT_TRUE(mirror.textures.empty());
}

TEST(GltfTextures, ASecondPlacementGetsTheSecondCoordinates) {
  const Scene scene = scene_of(R"({"emissiveFactor": [1, 1, 1],
      "emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}},
      "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})");
  const Material& material = scene.materials.at(0);
  EXPECT_FALSE(material.reads_second_uvs(TextureSlot::BaseColor));
  EXPECT_TRUE(material.reads_second_uvs(TextureSlot::Emissive));
  ASSERT_EQ(scene.meshes[0].second_uvs.size(), 3u);
  EXPECT_EQ(scene.meshes[0].second_uvs[1], 2.0f * scene.meshes[0].uvs[1]);
}

// Scaled, turned by a quarter and moved, in that order: +u becomes -v, which points up, and +v,
// which points down, becomes +u (KHR_texture_transform: counter-clockwise).
TEST(GltfTextures, CoordinatesAreScaledTurnedAndMoved) {
  const Scene scene = scene_of(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
      "extensions": {"KHR_texture_transform":
          {"scale": [2, 3], "rotation": 1.5707963267948966, "offset": [0.25, 0.5]}}}}})");
  const std::vector<glm::vec2>& uvs = scene.meshes[0].uvs;
  const glm::vec2 expected[] = {{0.25f, 0.5f}, {0.25f, -1.5f}, {3.25f, 0.5f}};
  ASSERT_EQ(uvs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::distance(uvs[i], expected[i]), 1e-6f) << i;
}

TEST(GltfTextures, AThirdPlacementIsNoted) {
  const Scene scene = scene_of(R"({"emissiveFactor": [1, 1, 1],
      "emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}},
      "normalTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [3, 3]}}},
      "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})");
  EXPECT_FALSE(scene.materials[0].normal_texture);
  EXPECT_THAT(scene.notes, testing::Contains(testing::HasSubstr("third set")));
}

TEST(GltfTextures, CoordinatesCanBeOfAnotherSet) {
  const Scene scene =
      scene_of(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}})",
               R"(, "TEXCOORD_1": 2)");
  EXPECT_EQ(scene.meshes[0].uvs.size(), 3u);
  const Scene without =
      scene_of(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}})");
  EXPECT_TRUE(without.meshes[0].uvs.empty());
  EXPECT_THAT(without.notes, testing::Contains(testing::HasSubstr("no texture coordinates")));
}

TEST(GltfTextures, VertexColorsAreRead) {
  const Scene scene = scene_of("{}", R"(, "COLOR_0": 1)");
  ASSERT_EQ(scene.meshes[0].colors.size(), 3u);
  EXPECT_EQ(scene.meshes[0].colors[0], glm::vec4(0, 0, 1, 1));
  EXPECT_TRUE(scene_of("{}").meshes[0].colors.empty());
}

TEST(GltfTextures, AnIndexOfZeroReflectsEverything) {
  const Scene scene = scene_of(R"({"pbrMetallicRoughness":
      {"baseColorFactor": [0.5, 0.2, 0.1, 1], "baseColorTexture": {"index": 0}},
      "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 0}}})");
  EXPECT_EQ(scene.materials[0].kind, MaterialKind::Mirror);
  EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1.0f));
  EXPECT_FALSE(scene.materials[0].base_color_texture);
}

}  // namespace
}  // namespace amalgam::scene
