#include "frame/scene_variant.h"

#include <gtest/gtest.h>

#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

scene::Scene mirror_and_floor() {
  scene::Scene scene;
  test_support::add_object(scene, test_support::make_floor(0.0f, 1.0f),
                           test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  test_support::add_object(scene, test_support::make_floor(1.0f, 1.0f), test_support::make_mirror(),
                           scene::Role::Virtual);
  return scene;
}

TEST(SceneVariant, HybridIsTheSceneItself) {
  EXPECT_EQ(scene_variant(mirror_and_floor(), RendererMode::Hybrid).instances.size(), 2u);
}

TEST(SceneVariant, RasterLeavesSpecularObjectsOut) {
  const scene::Scene scene = scene_variant(mirror_and_floor(), RendererMode::Raster);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.materials[scene.instances[0].material].kind, scene::MaterialKind::Diffuse);
}

TEST(SceneVariant, DiffusePaintsThem) {
  const scene::Scene scene = scene_variant(mirror_and_floor(), RendererMode::Diffuse);
  ASSERT_EQ(scene.instances.size(), 2u);
  for (const scene::Material& material : scene.materials) {
    EXPECT_EQ(material.kind, scene::MaterialKind::Diffuse);
  }
}

}  // namespace
}  // namespace amalgam::frame
