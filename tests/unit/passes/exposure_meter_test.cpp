#include "passes/image/exposure_meter.h"

#include <gtest/gtest.h>

#include <limits>

#include "passes/image/exposure.h"
#include "scene/light/tone_map.h"
#include "support/scene_builders.h"

namespace amalgam::passes {
namespace {

constexpr int kWidth = 64, kHeight = 48;

MeterGrid constant_grid(float radiance, int step = 4) {
  return {.real = common::ImageRgba32f(kWidth / step, kHeight / step,
                                       glm::vec4(glm::vec3(radiance), 1.0f)),
          .white = {},
          .step = step,
          .samples_per_side = 1};
}

std::optional<float> meter(const MeterGrid& grid, const common::ImageRgb8& image) {
  const common::CameraModel camera = test_support::make_pinhole(kWidth, kHeight, 50.0);
  return meter_exposure(grid, camera, camera, image);
}

// A grey card: tone-mapping the model with the metered exposure gives what the camera shows.
TEST(ExposureMeter, MakesTheModelLookLikeTheCameraImage) {
  const common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(150));
  for (const float radiance : {1e-4f, 0.3f, 40.0f}) {
    const auto exposure = meter(constant_grid(radiance), image);
    ASSERT_TRUE(exposure);
    EXPECT_EQ(
        scene::srgb_encode(scene::tone_map(glm::vec3(radiance), scene::tone_map_of(*exposure))),
        common::Rgb8(150));
  }
}

TEST(ExposureMeter, DoesNotMoveWithWhatTheModelDoesNotKnow) {
  common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(150));
  const auto expected = meter(constant_grid(0.5f), image);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth / 3; ++x)
      image.at(x, y) = common::Rgb8(20);  // a third is a dark thing
  }
  EXPECT_EQ(meter(constant_grid(0.5f), image), expected);
}

// Entry (x, y) is of the middle of its block: what the camera shows elsewhere does not count.
TEST(ExposureMeter, LooksAtThePixelsThatTheGridWasDrawnFor) {
  constexpr int kStep = 4;
  common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(60));
  for (int y = kStep / 2; y < kHeight; y += kStep) {
    for (int x = kStep / 2; x < kWidth; x += kStep) image.at(x, y) = common::Rgb8(150);
  }
  const common::ImageRgb8 everywhere(kWidth, kHeight, common::Rgb8(150));
  EXPECT_EQ(meter(constant_grid(0.5f, kStep), image),
            meter(constant_grid(0.5f, kStep), everywhere));
}

// numerics B18: black, infinite and missing pixels change nothing; nothing at all gives nothing.
TEST(ExposureMeter, UnusablePixelsDoNotCount) {
  const common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(150));
  const auto expected = meter(constant_grid(0.5f), image);
  MeterGrid grid = constant_grid(0.5f);
  grid.real.at(0, 0) = glm::vec4(std::numeric_limits<float>::infinity());
  grid.real.at(1, 0) = glm::vec4(std::numeric_limits<float>::quiet_NaN());
  for (int x = 2; x < grid.real.width(); ++x) grid.real.at(x, 0) = glm::vec4(0, 0, 0, 1);
  grid.real.at(0, 1) = glm::vec4(100, 100, 100, 0);  // not a real surface
  EXPECT_EQ(meter(grid, image), expected);
  EXPECT_FALSE(meter(constant_grid(0.0f), image));
  for (const common::Rgb8& clipped : {common::Rgb8(0), common::Rgb8(255)}) {
    EXPECT_FALSE(meter(constant_grid(0.5f), common::ImageRgb8(kWidth, kHeight, clipped)));
  }
}

}  // namespace
}  // namespace amalgam::passes
