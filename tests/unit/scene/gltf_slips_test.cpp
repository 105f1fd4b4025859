#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/scene/gltf_sample.h"

// Slips that cannot change the picture: the scene is read as if they were not there, with a note.
// What is refused stands in gltf_check_test.cpp.

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;

struct Slip {
  std::string from, to;  // in the sample
  std::string note;      // part of it; empty where the slip is not worth one
};

class GltfSlips : public testing::TestWithParam<Slip> {};

TEST_P(GltfSlips, AreNotedAndTheSceneIsTheSame) {
  const Scene expected = load_text(sample_gltf());
  const Scene scene = load_text(replaced(sample_gltf(), GetParam().from, GetParam().to));
  if (GetParam().note.empty()) {
    EXPECT_EQ(scene.notes, expected.notes);
  } else {
    EXPECT_THAT(scene.notes, Contains(HasSubstr(GetParam().note)));
  }
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].positions, expected.meshes[0].positions);
  EXPECT_EQ(scene.meshes[0].normals, expected.meshes[0].normals);
  EXPECT_EQ(scene.meshes[0].triangles, expected.meshes[0].triangles);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].anchor_from_mesh, expected.instances[0].anchor_from_mesh);
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].base_color, expected.materials[0].base_color);
  EXPECT_EQ(scene.materials[0].metallic, expected.materials[0].metallic);
}

const std::string kScene = R"("scene": 0)", kNode = R"("name": "thing", "mesh": 0)",
                  kIndices = R"("indices": 3)", kColor = "[1, 0, 0, 1]",
                  kLastView = R"({"buffer": 0, "byteOffset": 96, "byteLength": 8})",
                  kUvs = R"({"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"})";

Slip in_root(const std::string& added, const std::string& note) {
  return {kScene, kScene + ", " + added, note};
}
Slip in_node(const std::string& added, const std::string& note) {
  return {kNode, kNode + ", " + added, note};
}
INSTANTIATE_TEST_SUITE_P(
    EmptyLists, GltfSlips,
    testing::Values(
        in_root(R"("cameras": [])", "cameras: is empty"),
        in_root(R"("animations": [])", "animations: is empty"),
        in_root(R"("textures": [], "images": [], "samplers": [])", "textures: is empty"),
        in_root(R"("extensionsUsed": [])", "extensionsUsed: is empty"),
        in_root(R"("extensionsRequired": [])", "extensionsRequired: is empty"),
        in_root(R"("extensions": {"KHR_lights_punctual": {"lights": []}})", "lights: is empty"),
        in_node(R"("children": [])", "children: is empty"),
        Slip{R"("scene": 0,
"scenes": [{"nodes": [0]}],)",
             R"("scenes": [],)", "scenes: is empty"},
        Slip{R"([{"nodes": [0]}])", R"([{"nodes": [0]}, {"nodes": []}])",
             "scenes[1].nodes: is empty"},
        Slip{R"("material": 0}]}])", R"("material": 0}]}, {"primitives": []}])",
             "primitives: is empty"}));

INSTANTIATE_TEST_SUITE_P(
    NotUsed, GltfSlips,
    testing::Values(
        in_root(R"("cameras": [{"type": "perspective", "perspective": {"yfov": 0, "znear": -1}}])",
                "cameras are not used"),
        in_root(R"("cameras": [{"type": "fisheye"}])", "cameras are not used"),
        in_node(R"("camera": 7)", "cameras are not used"),
        in_node(R"("skin": 0)", "there is no skins[0]"),
        in_node(R"("weights": [1])", "morph targets are not used"),
        in_root(R"("skins": [{"joints": [9]}])", "skins are not used"),
        in_root(R"("animations": [{"samplers": [{"input": 99, "output": 0}], "channels": []}])",
                "animations are not played"),
        in_root(R"("images": [{"uri": "data:image/gif;base64,AAAA"}])", "image/gif"),
        in_root(R"("images": [{}])", "neither a uri nor a bufferView"),
        in_root(R"("samplers": [{"magFilter": 1}])", "is not a filter"),
        in_root(R"("extensionsUsed": ["KHR_xmp_json_ld", "KHR_xmp_json_ld"])", "occurs twice"),
        in_root(R"("extensionsUsed": ["EXT_mesh_gpu_instancing"])",
                "EXT_mesh_gpu_instancing is not supported, ignored"),
        in_root(R"("extensionsRequired": ["KHR_materials_ior"])", "missing from extensionsUsed"),
        in_root(R"("extensions": {"EXT_unheard_of": {}})", "not declared"),
        Slip{R"("version": "2.0")", R"("version": "2.0", "minVersion": "2.0", "generator": 5)", ""},
        Slip{kIndices, kIndices + R"(, "targets": [{"POSITION": 99}])", "targets are not used"},
        Slip{R"("NORMAL": 1)", R"("NORMAL": 1, "JOINTS_0": 3, "COLOUR": 1)",
             "COLOUR: is not an attribute"},
        Slip{R"("NORMAL": 1)", R"("NORMAL": 1, "_own": 99)", "not used"},
        Slip{R"("NORMAL": 1)", R"("NORMAL": 1, "_own": "x")", "not used"}));

INSTANTIATE_TEST_SUITE_P(
    Bytes, GltfSlips,
    testing::Values(
        Slip{R"("max": [1, 1, 0])", R"("max": [0.5, 1, 0])", "accessors[0]: element 1 is outside"},
        Slip{R"("min": [0, 0, 0])", R"("min": [0, 0])", "bounds are not used"},
        Slip{R"("min": [0, 0, 0])", R"("min": ["a", null, {}])", "bounds are not used"},
        Slip{R"(, "min": [0, 0, 0], "max": [1, 1, 0])", "", "no min and max"},
        Slip{R"("byteLength": 8}],
"buffers": [{"byteLength": 104)",
             R"("byteLength": 6}],
"buffers": [{"byteLength": 102)",
             "holds 104 bytes, but byteLength says 102"},
        Slip{kLastView, kLastView + R"(, {"buffer": 0, "byteLength": 0})",
             "bufferViews[4]: is empty"},
        Slip{R"("type": "SCALAR"}])",
             R"("type": "SCALAR"}, {"componentType": 5126, "count": 0, "type": "VEC2"}])",
             "accessors[4]: has no elements"},
        Slip{"application/octet-stream", "text/html", "media type 'text/html'"},
        Slip{"data:application/octet-stream", "data:", "media type ''"},
        Slip{R"("byteOffset": 0, "byteLength": 36)",
             R"("byteOffset": 0, "byteLength": 36, "byteStride": 0)", "byteStride"},
        Slip{R"("bufferView": 3, "componentType": 5123, "count": 3)",
             R"("bufferView": 3, "componentType": 5123.0, "count": 3.0, "byteOffset": 0)", ""},
        Slip{R"("bufferView": 2, "componentType": 5126)",
             R"("bufferView": 2, "normalized": true, "componentType": 5126)", "be normalized"},
        Slip{R"("byteOffset": 96, "byteLength": 8)",
             R"("byteOffset": 96, "byteLength": 8, "target": 34962)", ""},
        Slip{R"("TEXCOORD_0")", R"("TEXCOORD_1")", "not numbered"},
        Slip{kUvs, R"({"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2",
             "sparse": {"count": 0, "indices": {}, "values": {}}})",
             "sparse.count: is 0"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, GltfSlips,
    testing::Values(
        Slip{kColor, "[1.000001, 0, -1e-9, 1]", "a little outside its range"},
        Slip{R"("metallicFactor": 0)", R"("metallicFactor": -0.0001)", "a little outside"},
        in_node(R"("rotation": [0, 0, 0, 1.05])", "brought to length 1"),
        in_node(R"("matrix": [1,0,0,1e-9, 0,1,0,0, 0,0,1,0, 0,0,0,1])", "not quite 0 0 0 1")));

// A node that is scaled to nothing is valid glTF: a way to hide it.
TEST(GltfSlips, NodesScaledToNothingAreNotDrawn) {
  for (const char* scale : {"[0, 0, 0]", "[1, 0, 1]", "[1e-20, 1e-20, 1e-20]"}) {
    const Scene scene = load_text(replaced(
        replaced(sample_gltf(), "[{\"nodes\": [0]}]", "[{\"nodes\": [0, 1]}]"), "{" + kNode + "}",
        "{" + kNode + R"(}, {"rotation": [0.6, 0, 0, 0.8], "children": [2], "scale": )" + scale +
            R"(}, {"mesh": 0, "rotation": [0, 0.6, 0, 0.8]})"));
    EXPECT_EQ(scene.instances.size(), 1u) << scale;
    EXPECT_EQ(scene.instances[0].node, "thing");
    EXPECT_THAT(scene.notes, Contains("nodes[2]: is scaled to nothing, not drawn"));
  }
}

TEST(GltfSlips, LightsScaledToNothingAreLeftOut) {
  const Scene scene = load_text(replaced(
      replaced(sample_gltf(), kScene, kScene + R"(, "extensions":
               {"KHR_lights_punctual": {"lights": [{"type": "directional"}]}})"),
      kNode,
      kNode + R"(, "scale": [0, 0, 0], "extensions": {"KHR_lights_punctual": {"light": 0}})"));
  EXPECT_TRUE(scene.punctual_lights.empty());
  EXPECT_THAT(scene.notes, Contains(HasSubstr("its light is left out")));
}

Scene with_light(const std::string& light) {
  return load_text(
      replaced(replaced(sample_gltf(), kScene, kScene + R"(, "extensions": {"KHR_lights_punctual":
                        {"lights": [)" + light + "]}}"),
               kNode, kNode + R"(, "extensions": {"KHR_lights_punctual": {"light": 0}})"));
}

TEST(GltfSlips, SpotsWithEqualAnglesHaveAHardEdge) {
  for (const char* inner : {"0.5", "0.6"}) {
    const Scene scene =
        with_light(R"({"type": "spot", "spot": {"outerConeAngle": 0.5, "innerConeAngle": )" +
                   std::string(inner) + "}}");
    ASSERT_EQ(scene.punctual_lights.size(), 1u);
    EXPECT_FLOAT_EQ(scene.punctual_lights[0].cos_inner, std::cos(0.5f)) << inner;
    EXPECT_FLOAT_EQ(scene.punctual_lights[0].cos_outer, std::cos(0.5f)) << inner;
    EXPECT_THAT(scene.notes, Contains(HasSubstr("hard edge")));
  }
}

TEST(GltfSlips, LightsWithoutAngleOrRangeHaveTheDefaults) {
  const Scene spot = with_light(R"({"type": "spot"})");
  EXPECT_FLOAT_EQ(spot.punctual_lights.at(0).cos_inner, 1.0f);
  EXPECT_FLOAT_EQ(spot.punctual_lights.at(0).cos_outer, std::cos(0.785398163f));
  EXPECT_THAT(spot.notes, Contains(HasSubstr("without 'spot'")));
  const Scene point = with_light(R"({"type": "point", "range": 0})");
  EXPECT_EQ(point.punctual_lights.at(0).range, 0.0f);
  EXPECT_THAT(point.notes, Contains(HasSubstr("read as unlimited")));
}

TEST(GltfSlips, FactorsAreClampedOnlyByAHair) {
  const Scene bright = load_text(replaced(sample_gltf(), R"("name": "red",)",
                                          R"("name": "red", "emissiveFactor": [5, 0, 0],)"));
  EXPECT_EQ(bright.materials[0].emission, glm::vec3(5.0f, 0.0f, 0.0f));
  EXPECT_THAT(bright.notes, Contains(HasSubstr("emissiveFactor: is above 1")));
}

TEST(GltfSlips, AVolumeWithDistanceZeroDoesNotAbsorb) {
  const Scene scene = load_text(replaced(sample_gltf(), R"("name": "red",)",
                                         R"("name": "red", "extensions": {
      "KHR_materials_transmission": {"transmissionFactor": 1},
      "KHR_materials_volume": {"thicknessFactor": 1, "attenuationColor": [0.5, 0.5, 0.5],
      "attenuationDistance": 0}},)"));
  EXPECT_EQ(scene.materials[0].absorption, glm::vec3(0.0f));
  EXPECT_FALSE(scene.materials[0].thin);
  EXPECT_THAT(scene.notes, Contains(HasSubstr("read as without absorption")));
}

TEST(GltfSlips, GlassWithAlphaModeBlendIsCalledGlass) {
  const auto with = [](const std::string& factor) {
    return load_text(replaced(sample_gltf(), R"("name": "red",)",
                              R"("name": "red", "alphaMode": "BLEND", "extensions": {
        "KHR_materials_transmission": {"transmissionFactor": )" +
                                  factor + "}},"));
  };
  EXPECT_THAT(with("1").notes, Contains(HasSubstr("alpha blending ignored, drawn as glass")));
  EXPECT_THAT(with("0").notes, Contains(HasSubstr("drawn opaque")));
}

TEST(GltfSlips, AByteOrderMarkIsSkipped) {
  const Scene scene = load_text("\xEF\xBB\xBF" + sample_gltf());
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_THAT(scene.notes, Contains("begins with a byte order mark"));
}

}  // namespace
}  // namespace amalgam::scene
