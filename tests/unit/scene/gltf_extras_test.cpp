#include "scene/gltf/extras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A parent with a child that carries the mesh, both with the given extras.
Scene load_pair(const std::string& parent, const std::string& child) {
  return load_text(replaced(
      sample_gltf(), R"({"name": "thing", "mesh": 0})",
      R"({"translation": [5, 0, 0], "children": [1], "extras": )" + parent +
          R"(}, {"name": "thing", "mesh": 0, "translation": [0, 1, 0], "extras": )" + child + "}"));
}

TEST(GltfExtras, ChildrenInheritRoleAndMarker) {
  const Scene scene = load_pair(R"({"amalgam": {"role": "real", "marker": 23}})", "{}");
  EXPECT_EQ(scene.instances[0].role, Role::Real);
  EXPECT_EQ(scene.instances[0].marker, 23);
}

TEST(GltfExtras, WhatAChildSaysItselfCounts) {
  const Scene scene = load_pair(R"({"amalgam": {"role": "real", "marker": 23}})",
                                R"({"amalgam": {"role": "virtual"}})");
  EXPECT_EQ(scene.instances[0].role, Role::Virtual);
  EXPECT_EQ(scene.instances[0].marker, 23);
}

TEST(GltfExtras, BlendersShadowCatcherIsReal) {
  EXPECT_EQ(load_pair("{}", R"({"is_shadow_catcher": true})").instances[0].role, Role::Real);
  EXPECT_EQ(load_pair("{}", R"({"is_shadow_catcher": 1})").instances[0].role, Role::Real);
  EXPECT_EQ(load_pair("{}", R"({"is_shadow_catcher": false})").instances[0].role, Role::Virtual);
  EXPECT_EQ(load_pair("{}", R"({"is_shadow_catcher": true, "amalgam": {"role": "virtual"}})")
                .instances[0]
                .role,
            Role::Virtual);
}

TEST(GltfExtras, AnchorsAreMarkersFrames) {
  // The parent is bound to the marker: its own place counts within that marker's frame.
  const Scene bound = load_pair(R"({"amalgam": {"marker": 23}})", "{}");
  EXPECT_EQ(bound.instances[0].anchor_from_mesh[3], glm::dvec4(5, 1, 0, 1));
  // The child is: what stands above it belongs to the world marker's frame.
  const Scene child = load_pair("{}", R"({"amalgam": {"marker": 23}})");
  EXPECT_EQ(child.instances[0].anchor_from_mesh[3], glm::dvec4(0, 1, 0, 1));
}

// What Blender exports for custom properties of type String, Float and Boolean.
TEST(GltfExtras, BlendersPropertiesMayBeTexts) {
  const Scene scene = load_pair(R"({"amalgam": "{\"role\": \"real\", \"marker\": 23.0}"})", "{}");
  EXPECT_EQ(scene.instances[0].role, Role::Real);
  EXPECT_EQ(scene.instances[0].marker, 23);
  const Scene world =
      load_text(replaced(sample_gltf(), R"({"nodes": [0]})",
                         R"({"nodes": [0], "extras": {"amalgam": " {\"world_marker\": 40} "}})"));
  EXPECT_EQ(world.world.marker, 40);
}

TEST(GltfExtras, ATextThatIsNoObjectIsRefused) {
  const auto refusal = [](const std::string& text) {
    return refusal_of(replaced(sample_gltf(), R"({"name": "thing")",
                               R"({"extras": {"amalgam": ")" + text + R"("}, "name": "thing")"));
  };
  // Python's quotes, which a property of type Python takes.
  EXPECT_THAT(refusal("{'role': 'real'}"),
              AllOf(HasSubstr("nodes[0].extras.amalgam"), HasSubstr("double quotes")));
  EXPECT_THAT(refusal(""), HasSubstr("nodes[0].extras.amalgam: is a text that holds no JSON"));
  EXPECT_THAT(refusal("real"), HasSubstr("holds no JSON"));
  EXPECT_THAT(refusal("[3]"), HasSubstr("nodes[0].extras.amalgam: expected an object"));
  EXPECT_THAT(refusal(R"({\"role\": \"ghost\"})"),
              HasSubstr("nodes[0].extras.amalgam.role: 'ghost'"));
}

TEST(GltfExtras, ForeignExtrasAreNobodysBusiness) {
  for (const char* extras : {"17", "null", R"("text")", "[1, 2]", R"({"amalgamated": 3})"}) {
    EXPECT_EQ(load_pair(extras, "{}").instances[0].role, Role::Virtual) << extras;
  }
}

TEST(GltfExtras, OurOwnMustBeRight) {
  const auto refusal = [](const std::string& extras) {
    return refusal_of(replaced(sample_gltf(), R"({"name": "thing")",
                               R"({"extras": )" + extras + R"(, "name": "thing")"));
  };
  EXPECT_THAT(refusal(R"({"amalgam": 3})"), HasSubstr("nodes[0].extras.amalgam"));
  EXPECT_THAT(refusal(R"({"amalgam": {"role": "ghost"}})"),
              HasSubstr("'ghost' is neither real nor virtual"));
  EXPECT_THAT(refusal(R"({"amalgam": {"marker": -1}})"), HasSubstr("marker"));
  EXPECT_THAT(refusal(R"({"amalgam": {"marker": 1.5}})"), HasSubstr("integer"));
  EXPECT_THAT(refusal(R"({"amalgam": {"roll": "real"}})"), HasSubstr("unknown"));
}

TEST(GltfExtras, TheSceneSaysItsWorld) {
  const Scene scene = load_text(replaced(
      sample_gltf(), R"({"nodes": [0]})",
      R"({"nodes": [0], "extras": {"amalgam": {"world_marker": 40, "dictionary": "DICT_4X4_50", "marker_length": 0.08}}})"));
  EXPECT_EQ(scene.world.marker, 40);
  EXPECT_EQ(scene.world.dictionary, "DICT_4X4_50");
  EXPECT_EQ(scene.world.marker_length, 0.08);
  EXPECT_THAT(
      refusal_of(replaced(sample_gltf(), R"({"nodes": [0]})",
                          R"({"nodes": [0], "extras": {"amalgam": {"marker_length": 0}}})")),
      HasSubstr("scenes[0].extras.amalgam.marker_length"));
}

TEST(GltfExtras, LightsComeWithTheirNodes) {
  const Scene scene = load_text(replaced(
      replaced(
          sample_gltf(), R"({"name": "thing", "mesh": 0})",
          R"({"name": "thing", "mesh": 0, "translation": [0, 3, 0], "extras": {"amalgam": {"marker": 9}},
                   "extensions": {"KHR_lights_punctual": {"light": 1}}})"),
      R"("accessors")",
      R"("extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
         {"type": "directional"},
         {"type": "spot", "color": [1, 0.5, 0], "intensity": 40, "range": 2, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}]}},
         "accessors")"));
  ASSERT_EQ(scene.punctual_lights.size(), 1u);
  const PunctualLight& light = scene.punctual_lights[0];
  EXPECT_EQ(light.kind, PunctualLight::Kind::Spot);
  EXPECT_EQ(light.intensity, glm::vec3(40, 20, 0));
  EXPECT_EQ(light.range, 2.0f);
  EXPECT_FLOAT_EQ(light.cos_inner, std::cos(0.1f));
  EXPECT_FLOAT_EQ(light.cos_outer, std::cos(0.5f));
  EXPECT_EQ(light.marker, 9);
  EXPECT_EQ(light.anchor_from_light[3], glm::dvec4(0, 3, 0, 1));
}

TEST(GltfExtras, WrongLightsAreRefused) {
  const auto refusal = [](const std::string& lights, int index) {
    return refusal_of(replaced(
        replaced(sample_gltf(), R"({"name": "thing", "mesh": 0})",
                 R"({"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": )" +
                     std::to_string(index) + "}}}"),
        R"("accessors")",
        R"("extensions": {"KHR_lights_punctual": {"lights": [)" + lights + R"(]}}, "accessors")"));
  };
  EXPECT_THAT(refusal(R"({"type": "point"})", 1), HasSubstr("no such light"));
  EXPECT_THAT(refusal(R"({"type": "moon"})", 0), HasSubstr("moon"));
  EXPECT_THAT(refusal(R"({"type": "point", "intensity": -1})", 0), HasSubstr("intensity"));
  EXPECT_THAT(refusal(R"({"type": "spot", "spot": {"outerConeAngle": 2}})", 0), HasSubstr("Cone"));
}

}  // namespace
}  // namespace amalgam::scene
