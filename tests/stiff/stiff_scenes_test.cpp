// What the stiff scenes hold.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/bounds.h"
#include "scene/gltf/loader.h"
#include "support/stiff_scenes.h"

namespace amalgam::stiff {
namespace {

using test_support::stiff_scenes;
using test_support::StiffScene;

TEST(StiffScenes, AreReadWithoutLeavingAnythingOut) {
  for (const StiffScene& stiff : stiff_scenes()) {
    const scene::Scene scene = scene::load_scene(stiff.file);
    EXPECT_TRUE(scene.notes.empty()) << stiff.name << ": " << scene.notes.front();
    EXPECT_TRUE(common::is_usable(stiff.pose)) << stiff.name;
    EXPECT_EQ(scene.world.marker, stiff.pose.marker) << stiff.name;
  }
}

// What is cut off errs by no more than the brightest light, so that light has to be dim.
TEST(StiffScenes, AreLitSoftly) {
  for (const StiffScene& stiff : stiff_scenes()) {
    const scene::Scene scene = scene::load_scene(stiff.file);
    ASSERT_TRUE(scene.environment) << stiff.name;
    for (const glm::vec3& texel : scene.environment->radiance.pixels()) {
      ASSERT_GE(std::min({texel.r, texel.g, texel.b}), 0.199f) << stiff.name;
      ASSERT_LE(std::max({texel.r, texel.g, texel.b}), 2.001f) << stiff.name;
    }
  }
}

// Vertices have the scene's size: a transform that scaled them would hide what is fixed in metres.
TEST(StiffScenes, VerticesAreAsLargeAsTheScene) {
  for (const StiffScene& stiff : stiff_scenes()) {
    const scene::Scene scene = scene::load_scene(stiff.file);
    for (const scene::Instance& instance : scene.instances) {
      const scene::Bounds bounds = scene::bounds_of(scene.meshes[instance.mesh]);
      const glm::vec3 extent = bounds.high - bounds.low;
      const double largest = std::max({extent.x, extent.y, extent.z});
      EXPECT_GT(largest, 0.5 * stiff.size) << stiff.name << ": " << instance.node;
      EXPECT_LT(largest, 3.1 * stiff.size) << stiff.name << ": " << instance.node;
    }
  }
}

TEST(StiffScenes, MaterialsAreAsTheListSays) {
  for (const StiffScene& stiff : stiff_scenes()) {
    const scene::Scene scene = scene::load_scene(stiff.file);
    for (const scene::Instance& instance : scene.instances) {
      const scene::Material& material = scene.materials[instance.material];
      if (instance.role == scene::Role::Real) {
        EXPECT_EQ(material.kind, scene::MaterialKind::Diffuse) << stiff.name;
      } else if (stiff.kind == StiffScene::Kind::Corridor) {
        EXPECT_EQ(material.kind, scene::MaterialKind::Mirror) << stiff.name;
        EXPECT_FLOAT_EQ(material.base_color.g, static_cast<float>(stiff.parameter)) << stiff.name;
      } else {
        EXPECT_EQ(material.kind, scene::MaterialKind::Dielectric) << stiff.name;
        EXPECT_FALSE(material.thin) << stiff.name;
      }
      if (stiff.kind == StiffScene::Kind::Ball && instance.role == scene::Role::Virtual) {
        EXPECT_FLOAT_EQ(material.ior, static_cast<float>(stiff.parameter)) << stiff.name;
      }
      if (stiff.kind == StiffScene::Kind::Stack && instance.role == scene::Role::Virtual) {
        EXPECT_EQ(scene.meshes[instance.mesh].triangles.size(), 12.0 * stiff.parameter);
        EXPECT_FLOAT_EQ(material.ior, static_cast<float>(test_support::kStackIndex));
      }
    }
  }
}

}  // namespace
}  // namespace amalgam::stiff
