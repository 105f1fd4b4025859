// Masks leave no rims: where rasterised, traced and camera pixels meet, each sample counts once.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <string>
#include <tuple>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/light/tone_map.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

constexpr int kMarker = 40, kWidth = 96, kHeight = 72;
constexpr float kRadiance = 9.0f;  // TM(9) = 0.9

scene::Material glowing(scene::Material material) {
  material.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  material.emission = glm::vec3(kRadiance);
  return material;
}

// One bright tile of two halves, the left one rasterised and the right one traced, that glow alike
// and reflect nothing, turned so that no edge lies along the pixels.
scene::Scene make_tile() {
  scene::Scene scene;
  scene.world.marker = kMarker;
  const glm::mat4 turned =
      glm::rotate(glm::mat4(1.0f), glm::radians(23.0f), glm::vec3(0.0f, 1.0f, 0.0f));
  for (const float side : {-1.0f, 1.0f}) {
    test_support::add_object(
        scene, test_support::make_quad({0.05f * side, 0.0f, 0.0f}, {0.05f, 0, 0}, {0, 0, -0.07f}),
        glowing(side < 0.0f ? test_support::make_diffuse(glm::vec3(0.0f))
                            : test_support::make_mirror()),
        scene::Role::Virtual, turned);
  }
  return scene;
}

FrameOutput render(RendererMode mode, const char* samples, const common::ImageRgb8& image) {
  RendererSettings settings;
  settings.mode = mode;
  settings.exposure = 1.0f;
  parse_samples(samples, settings);
  FrameRenderer renderer(make_tile(), settings);
  ViewState view({.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true});
  return renderer.render(view, {image, {default_pose(kMarker)}});
}

// The bytes that k of n samples may leave on a black camera image.
std::set<int> bytes_of_coverages(int n) {
  std::set<int> bytes;
  for (int k = 0; k <= n; ++k) {
    bytes.insert(
        scene::srgb_encode(glm::vec3(0.9f * static_cast<float>(k) / static_cast<float>(n))).r);
  }
  return bytes;
}

using Parameters = std::tuple<RendererMode, const char*>;

std::string test_name(const testing::TestParamInfo<Parameters>& info) {
  const auto& [mode, samples] = info.param;
  return (mode == RendererMode::Hybrid ? "Hybrid" : "Raytrace") + std::string(samples);
}

class SuperSampling : public testing::TestWithParam<Parameters> {};

TEST_P(SuperSampling, BrightOnDarkIsCoverageTimesTheObject) {
  const auto [mode, samples] = GetParam();
  const bool adaptive = samples[0] == 'a';
  const int n = adaptive ? 9 : std::atoi(samples);
  const std::set<int> allowed = bytes_of_coverages(n);
  const FrameOutput output = render(mode, samples, common::ImageRgb8(kWidth, kHeight));
  int full = 0, partly = 0;
  double coverage = 0.0;
  for (const common::Rgb8& pixel : output.pixels.pixels()) {
    EXPECT_TRUE(allowed.contains(pixel.r)) << int{pixel.r};
    EXPECT_EQ(pixel.r, pixel.b);
    full += pixel.r == *allowed.rbegin() ? 1 : 0;
    partly += pixel.r != 0 && pixel.r != *allowed.rbegin() ? 1 : 0;
    coverage += scene::srgb_decode(pixel).r / 0.9;
  }
  EXPECT_GT(full, 300);
  EXPECT_EQ(partly > 0, n > 1);
  // The perimeter only: a dark or bright seam between the halves would add its length.
  EXPECT_LT(partly, 160);
  const FrameOutput finest =
      render(RendererMode::Raytrace, "16", common::ImageRgb8(kWidth, kHeight));
  double exact = 0.0;
  for (const common::Rgb8& pixel : finest.pixels.pixels()) {
    exact += scene::srgb_decode(pixel).r / 0.9;
  }
  EXPECT_NEAR(coverage, exact, 0.03 * exact) << "the tile's area, pixels";
}

// The other way round nothing of the camera's white may be left under what is covered, or lost.
TEST_P(SuperSampling, DarkOnBrightNeitherGlowsNorLosesTheCamera) {
  const auto [mode, samples] = GetParam();
  const FrameOutput output =
      render(mode, samples, common::ImageRgb8(kWidth, kHeight, common::Rgb8(255)));
  const int object = scene::srgb_encode(glm::vec3(0.9f)).r;
  for (const common::Rgb8& pixel : output.pixels.pixels()) {
    ASSERT_GE(pixel.r, object);
    ASSERT_EQ(pixel.r, pixel.g);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSamples, SuperSampling,
                         testing::Combine(testing::Values(RendererMode::Hybrid,
                                                          RendererMode::Raytrace),
                                          testing::Values("1", "4", "9", "16", "adaptive")),
                         test_name);

// Statistics count pixels, however many samples each has.
TEST(SuperSampling, PixelsAreCountedAndNotSamples) {
  const common::ImageRgb8 black(kWidth, kHeight);
  for (const RendererMode mode : {RendererMode::Hybrid, RendererMode::Raytrace}) {
    const auto one = render(mode, "1", black).statistics.pixels;
    const auto nine = render(mode, "9", black).statistics.pixels;
    ASSERT_GT(one.specular, 100u);
    EXPECT_NEAR(static_cast<double>(nine.specular) / static_cast<double>(one.specular), 1.0, 0.1);
    EXPECT_NEAR(static_cast<double>(nine.virtual_pixels) / static_cast<double>(one.virtual_pixels),
                1.0, 0.1);
    EXPECT_EQ(nine.total, one.total);
  }
}

}  // namespace
}  // namespace amalgam::frame
