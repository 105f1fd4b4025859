#include "scene/features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace amalgam::scene {
namespace {

Scene scene_of(std::initializer_list<std::pair<Role, MaterialKind>> objects) {
  Scene scene;
  scene.meshes.resize(1);
  for (const auto& [role, kind] : objects) {
    Instance instance;
    instance.role = role;
    instance.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.instances.push_back(instance);
    scene.materials.emplace_back().kind = kind;
  }
  return scene;
}

bool is_absent(const SceneFeatures& features, const std::string& what) {
  for (const Absence& absence : describe_absences(features)) {
    if (absence.what.find(what) != std::string::npos) return !absence.reason.empty();
  }
  return false;
}

TEST(Features, AnEmptySceneNeedsNothing) {
  const SceneFeatures features = scene_features(Scene());
  EXPECT_EQ(features, SceneFeatures());
  EXPECT_TRUE(is_absent(features, "everything"));
  EXPECT_TRUE(is_absent(features, "trace"));
  EXPECT_TRUE(is_absent(features, "diffuse pass"));
}

TEST(Features, DiffuseScenesAreNotTraced) {
  const SceneFeatures features = scene_features(
      scene_of({{Role::Real, MaterialKind::Diffuse}, {Role::Virtual, MaterialKind::Diffuse}}));
  EXPECT_TRUE(features.has_virtual && features.has_real && features.has_diffuse &&
              features.has_real_diffuse);
  EXPECT_FALSE(features.has_specular || features.has_transmissive);
  EXPECT_TRUE(is_absent(features, "Embree"));
  EXPECT_FALSE(is_absent(features, "diffuse pass"));
}

TEST(Features, MirrorsNeedNoRefraction) {
  const SceneFeatures features = scene_features(
      scene_of({{Role::Real, MaterialKind::Diffuse}, {Role::Virtual, MaterialKind::Mirror}}));
  EXPECT_TRUE(features.has_specular && features.has_virtual_specular);
  EXPECT_FALSE(features.has_real_specular);
  EXPECT_TRUE(is_absent(features, "refraction"));
  EXPECT_TRUE(is_absent(features, "difference part"));
  EXPECT_FALSE(is_absent(features, "Embree"));
}

TEST(Features, RealMirrorsAndGlassAreTold) {
  const SceneFeatures features = scene_features(
      scene_of({{Role::Real, MaterialKind::Mirror}, {Role::Virtual, MaterialKind::Dielectric}}));
  EXPECT_TRUE(features.has_real_specular && features.has_transmissive);
  EXPECT_FALSE(features.has_diffuse);
  EXPECT_TRUE(is_absent(features, "camera look-ups"));  // nothing real that is diffuse
}

TEST(Features, TexturesCountOnlyWithCoordinates) {
  Scene scene = scene_of({{Role::Virtual, MaterialKind::Diffuse}});
  scene.materials[0].base_color_texture = 0;
  EXPECT_FALSE(scene_features(scene).has_textures);
  scene.meshes[0].uvs.resize(3);
  EXPECT_TRUE(scene_features(scene).has_textures);
}

TEST(Features, EnvironmentAndLights) {
  Scene scene;
  EXPECT_TRUE(is_absent(scene_features(scene), "environment"));
  scene.environment.emplace().low_dynamic_range = true;
  scene.punctual_lights.resize(1);
  const SceneFeatures features = scene_features(scene);
  EXPECT_TRUE(features.has_environment && features.has_low_dynamic_range_environment &&
              features.has_punctual_lights);
}

}  // namespace
}  // namespace amalgam::scene
