#include "passes/image/composite.h"

#include <gtest/gtest.h>

#include "scene/light/tone_map.h"

namespace amalgam::passes {
namespace {

common::ImageRgb8 all_bytes() {
  common::ImageRgb8 image(256, 1);
  for (int i = 0; i < 256; ++i) image.at(i, 0) = common::Rgb8(i, 255 - i, (7 * i) % 256);
  return image;
}

core::Layers empty_layers(int width, int height) {
  return core::Layers({width, height});
}

TEST(Composite, EmptyLayersLeaveEveryByteAlone) {
  EXPECT_EQ(composite(empty_layers(256, 1), all_bytes()), all_bytes());
}

// A difference far below one step of a byte still goes the whole way through decode and encode.
TEST(Composite, DecodeAndEncodeKeepEveryByte) {
  core::Layers layers = empty_layers(256, 1);
  for (int x = 0; x < 256; ++x) layers.set(x, 0, {glm::vec4(0.0f), glm::vec3(1e-9f)});
  EXPECT_EQ(composite(layers, all_bytes()), all_bytes());
}

// Eq. 4.5 for a covered, a half-covered and an uncovered pixel.
TEST(Composite, CoversAddsAndMixes) {
  core::Layers layers = empty_layers(3, 1);
  layers.set(0, 0, {glm::vec4(0.2f, 0.4f, 0.6f, 1.0f), glm::vec3(0.0f)});
  layers.set(1, 0, {glm::vec4(0.1f, 0.2f, 0.3f, 0.5f), glm::vec3(0.0f)});
  layers.set(2, 0, {glm::vec4(0.0f), glm::vec3(-0.1f, 0.0f, 0.1f)});
  const common::ImageRgb8 camera(3, 1, scene::srgb_encode(glm::vec3(0.5f)));
  const glm::vec3 seen = scene::srgb_decode(camera.at(0, 0));
  const common::ImageRgb8 out = composite(layers, camera);
  EXPECT_EQ(out.at(0, 0), scene::srgb_encode(glm::vec3(0.2f, 0.4f, 0.6f)));
  EXPECT_EQ(out.at(1, 0), scene::srgb_encode(glm::vec3(0.1f, 0.2f, 0.3f) + 0.5f * seen));
  EXPECT_EQ(out.at(2, 0), scene::srgb_encode(seen + glm::vec3(-0.1f, 0.0f, 0.1f)));
}

// All of eq. 4.5 in one pixel: what is covered takes from the camera alone and not from the
// difference, and all is added before anything is cut to what a byte holds.
TEST(Composite, AddsEverythingInLinearLightAndClampsLast) {
  core::Layers layers = empty_layers(2, 1);
  const glm::vec4 over(0.1f, 0.2f, 0.05f, 0.25f);
  const glm::vec3 difference(0.2f, -0.05f, 0.1f);
  layers.set(0, 0, {over, difference});
  layers.set(1, 0, {glm::vec4(1.5f, 1.75f, 2.0f, 1.0f), glm::vec3(-1.0f, -1.5f, -1.25f)});
  const common::ImageRgb8 camera(2, 1, common::Rgb8(120, 90, 200));
  const glm::vec3 seen = scene::srgb_decode(camera.at(0, 0));
  const common::ImageRgb8 out = composite(layers, camera);
  EXPECT_EQ(out.at(0, 0), scene::srgb_encode(glm::vec3(over) + 0.75f * seen + difference));
  EXPECT_EQ(out.at(1, 0), scene::srgb_encode(glm::vec3(0.5f, 0.25f, 0.75f)));
}

// The light on what is not covered is scaled in radiance, whatever the exposure.
TEST(Composite, ScalesTheLightOfTheCameraImage) {
  core::Layers layers = empty_layers(3, 1);
  layers.set(0, 0, {.relative_change = glm::vec3(-0.5f, 0.0f, -1.0f)});
  layers.set(1, 0,
             {.over = glm::vec4(0.1f, 0.1f, 0.1f, 0.75f), .relative_change = glm::vec3(-0.125f)});
  const common::ImageRgb8 camera(3, 1, scene::srgb_encode(glm::vec3(0.5f)));
  const float seen = scene::srgb_decode(camera.at(0, 0)).x;
  const common::ImageRgb8 reinhard = composite(layers, camera);
  const float halved = scene::compress(0.5f * scene::expand(seen));
  EXPECT_EQ(reinhard.at(0, 0), scene::srgb_encode(glm::vec3(halved, seen, 0.0f)));
  EXPECT_EQ(reinhard.at(1, 0), scene::srgb_encode(glm::vec3(0.1f + 0.25f * halved)));
  EXPECT_EQ(reinhard.at(2, 0), camera.at(2, 0));
  const common::ImageRgb8 linear = composite(layers, camera, scene::ToneCurve::Linear);
  EXPECT_EQ(linear.at(0, 0), scene::srgb_encode(glm::vec3(0.5f * seen, seen, 0.0f)));
  EXPECT_EQ(linear.at(1, 0), scene::srgb_encode(glm::vec3(0.1f + 0.125f * seen)));
}

// A bright object on a dark image: the half-covered pixel lies between the two, without a rim.
TEST(Composite, HalfCoverageHasNoRim) {
  core::Layers layers = empty_layers(1, 1);
  layers.set(0, 0,
             {glm::vec4(glm::vec3(0.45f), 0.5f),
              glm::vec3(0.0f)});  // an object of 0.9 over half the pixel
  const common::ImageRgb8 out = composite(layers, common::ImageRgb8(1, 1, common::Rgb8(0)));
  EXPECT_EQ(out.at(0, 0), scene::srgb_encode(glm::vec3(0.45f)));
}

TEST(Composite, ClampsToWhatAByteHolds) {
  core::Layers layers = empty_layers(2, 1);
  layers.set(0, 0, {glm::vec4(0.0f), glm::vec3(5.0f)});
  layers.set(1, 0, {glm::vec4(0.0f), glm::vec3(-5.0f)});
  const common::ImageRgb8 out = composite(layers, common::ImageRgb8(2, 1, common::Rgb8(100)));
  EXPECT_EQ(out.at(0, 0), common::Rgb8(255));
  EXPECT_EQ(out.at(1, 0), common::Rgb8(0));
}

}  // namespace
}  // namespace amalgam::passes
