#include "report/float_composite.h"

#include <gtest/gtest.h>

#include "scene/light/tone_map.h"

namespace amalgam::report {
namespace {

constexpr int kSide = 16;

common::ImageRgb8 camera_image() {
  return common::ImageRgb8(kSide, kSide, common::Rgb8(128, 64, 200));
}

// Half covered, with a shadow on the rest.
TEST(FloatComposite, IsEquation45) {
  core::Layers layers({kSide, kSide});
  layers.set(3, 2, {{0.2f, 0.1f, 0.0f, 0.5f}, {-0.05f, 0.0f, 0.01f}});
  const common::ImageRgb32f composite = float_composite(layers, camera_image());
  const glm::vec3 camera = scene::srgb_decode(common::Rgb8(128, 64, 200));
  const glm::vec3 expected =
      glm::vec3(0.2f, 0.1f, 0.0f) + 0.5f * camera + glm::vec3(-0.05f, 0.0f, 0.01f);
  EXPECT_EQ(composite.at(3, 2), expected);
  EXPECT_EQ(composite.at(2, 3), camera);
}

TEST(FloatComposite, IsWhatADisplayShows) {
  core::Layers layers({kSide, kSide});
  layers.set(0, 0, {{1.5f, 0.0f, 0.0f, 1.0f}, {0.0f, -0.5f, 0.25f}});
  EXPECT_EQ(float_composite(layers, camera_image()).at(0, 0), glm::vec3(1.0f, 0.0f, 0.25f));
}

TEST(FloatComposite, OfTheReferencesLayersToo) {
  reference::Layers layers = reference::Layers::zero(kSide, kSide);
  layers.over.at(1, 4) = {0.25, 0.5, 0.75, 1.0};
  layers.difference.at(2, 4) = {-1.0, 0.0, 0.0};
  const common::ImageRgb32f composite = float_composite(layers, camera_image());
  EXPECT_EQ(composite.at(1, 4), glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(composite.at(2, 4).r, 0.0f);
}

TEST(FloatComposite, AFrameWithoutBuffersChangesNothing) {
  EXPECT_TRUE(frame_layers({}, {kSide, kSide}, 1.0f).is_zero());
  EXPECT_EQ(frame_layers({}, {kSide, kSide}, 0.5f).size(), glm::ivec2(kSide));
}

// Rendered at half the size, with the border that passes/image/warp.h says.
TEST(FloatComposite, SmallLayersAreScaledUp) {
  constexpr int kSmall = kSide / 2 + 2;
  const frame::FrameBuffers buffers{
      {"over", common::ImageRgba32f(kSmall, kSmall, glm::vec4(0.3f, 0.3f, 0.3f, 1.0f))},
      {"difference", common::ImageRgb32f(kSmall, kSmall)},
      {"light_ratio", common::ImageRgb32f(kSmall, kSmall, glm::vec3(1.0f))}};
  const core::Layers layers = frame_layers(buffers, {kSide, kSide}, 0.5f);
  ASSERT_EQ(layers.size(), glm::ivec2(kSide));
  EXPECT_NEAR(layers.at(0, 0).over.r, 0.3f, 1e-6f);
  EXPECT_NEAR(layers.at(kSide - 1, kSide - 1).over.w, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace amalgam::report
