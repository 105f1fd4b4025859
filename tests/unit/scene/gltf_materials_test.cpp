#include "scene/gltf/materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

// The sample's material replaced by the given JSON.
Material material_of(const std::string& json) {
  const std::string text = replaced(
      sample_gltf(),
      R"({"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0}})",
      json);
  return load_text(text).materials.at(0);
}

std::string pbr(double metallic, double roughness) {
  return R"({"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.8, 0.7, 1], "metallicFactor": )" +
         std::to_string(metallic) + R"(, "roughnessFactor": )" + std::to_string(roughness) + "}}";
}

TEST(GltfMaterials, SmoothMetalIsAMirror) {
  const Material mirror = material_of(pbr(0.5, 0.2));
  EXPECT_EQ(mirror.kind, MaterialKind::Mirror);
  EXPECT_EQ(glm::vec3(mirror.base_color), glm::vec3(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(material_of(pbr(0.49, 0.0)).kind, MaterialKind::Diffuse);
  EXPECT_EQ(material_of(pbr(1.0, 0.21)).kind, MaterialKind::Diffuse);
}

TEST(GltfMaterials, TransmissionIsADielectricWhateverElseItSays) {
  const Material glass = material_of(
      R"({"pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0},
          "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}}})");
  EXPECT_EQ(glass.kind, MaterialKind::Dielectric);
  EXPECT_EQ(glass.ior, 1.5f);
  EXPECT_TRUE(glass.thin);
  EXPECT_EQ(glass.absorption, glm::vec3(0.0f));
  EXPECT_EQ(
      material_of(R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.49}}})")
          .kind,
      MaterialKind::Diffuse);
}

TEST(GltfMaterials, VolumeAbsorbsByItsColorOverItsDistance) {
  const Material glass = material_of(
      R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.33},
          "KHR_materials_volume": {"thicknessFactor": 0.01, "attenuationDistance": 0.1, "attenuationColor": [0.5, 1, 0]}}})");
  EXPECT_FALSE(glass.thin);
  EXPECT_EQ(glass.ior, 1.33f);
  EXPECT_NEAR(glass.absorption.x, std::log(2.0) / 0.1, 1e-4);
  EXPECT_EQ(glass.absorption.y, 0.0f);
  EXPECT_TRUE(std::isfinite(glass.absorption.z));
  EXPECT_LT(std::exp(-glass.absorption.z * 0.1f), 1e-5f);  // black, without infinity
}

TEST(GltfMaterials, VolumeWithoutThicknessIsThinAndWithoutDistanceClear) {
  const Material thin = material_of(
      R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
          "KHR_materials_volume": {"attenuationDistance": 0.1, "attenuationColor": [0.5, 1, 0]}}})");
  EXPECT_TRUE(thin.thin);
  EXPECT_EQ(thin.absorption, glm::vec3(0.0f));
  const Material clear = material_of(
      R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
          "KHR_materials_volume": {"thicknessFactor": 1, "attenuationColor": [0.5, 1, 0]}}})");
  EXPECT_FALSE(clear.thin);
  EXPECT_EQ(clear.absorption, glm::vec3(0.0f));
}

TEST(GltfMaterials, EmissionIsMultipliedByItsStrength) {
  const Material lamp = material_of(
      R"({"emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}})");
  EXPECT_EQ(lamp.emission, glm::vec3(8.0f, 4.0f, 0.0f));
}

TEST(GltfMaterials, MaskAndSidesAreKept) {
  const Material leaf =
      material_of(R"({"alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true})");
  EXPECT_EQ(leaf.alpha_cutoff, 0.25f);
  EXPECT_TRUE(leaf.double_sided);
  EXPECT_EQ(material_of(R"({"alphaMode": "MASK"})").alpha_cutoff, 0.5f);
  EXPECT_FALSE(material_of(R"({"alphaMode": "BLEND"})").alpha_cutoff);
}

TEST(GltfMaterials, WithoutAMaterialTheDefaultIsAdded) {
  const Scene scene = load_text(replaced(sample_gltf(), R"(, "material": 0)", ""));
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.instances[0].material, 1u);
  EXPECT_EQ(scene.materials[1].name, "default");
  EXPECT_EQ(scene.materials[1].kind, MaterialKind::Diffuse);
}

TEST(GltfMaterials, WhatIsIgnoredIsNoted) {
  const Scene scene = load_text(replaced(sample_gltf(), R"({"name": "red", )",
                                         R"({"name": "red", "alphaMode": "BLEND", "extensions":
                                            {"KHR_materials_sheen": {}}, )"));
  EXPECT_THAT(scene.notes, testing::Contains(testing::HasSubstr("alpha blending")));
  EXPECT_THAT(scene.notes, testing::Contains(testing::HasSubstr("KHR_materials_sheen ignored")));
}

TEST(GltfMaterials, NonsenseIsRefused) {
  const auto refusal = [](const std::string& json) {
    return refusal_of(
        replaced(sample_gltf(), R"({"name": "red", )", R"({"name": "red", )" + json + ", "));
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal(R"("alphaMode": "GLASS")"), HasSubstr("materials[0].alphaMode"));
  EXPECT_THAT(refusal(R"("emissiveFactor": [-2, 0, 0])"), HasSubstr("emissiveFactor[0]"));
  EXPECT_THAT(refusal(R"("normalTexture": {"index": 4})"), HasSubstr("there is no textures[4]"));
  EXPECT_THAT(refusal(R"("extensions": {"KHR_materials_ior": {"ior": 0.5}})"), HasSubstr("ior"));
  EXPECT_THAT(refusal(R"("extensions": {"KHR_materials_volume": {"attenuationDistance": -1}})"),
              HasSubstr("attenuationDistance"));
}

}  // namespace
}  // namespace amalgam::scene
