// numerics B18: the exposure meter takes the median over pixels that can be compared, however few
// those are and however many others are black; and unlike an average it holds until outliers are
// half of them.
#include <gtest/gtest.h>

#include <limits>

#include "passes/image/exposure_meter.h"
#include "scene/light/tone_map.h"
#include "support/scene_builders.h"

namespace amalgam::passes {
namespace {

constexpr int kWidth = 100, kHeight = 80, kCount = kWidth * kHeight;
constexpr float kRadiance = 0.5f;

// Of a picture of an even grey, with as many of the model's pixels set to this value.
std::optional<float> metered_with(int changed, float value, float radiance = kRadiance) {
  MeterGrid grid{
      .real = common::ImageRgba32f(kWidth, kHeight, glm::vec4(glm::vec3(radiance), 1.0f)),
      .white = {},
      .step = 1,
      .samples_per_side = 1};
  for (int i = 0; i < changed; ++i) {
    grid.real.pixels()[static_cast<std::size_t>(i)] = glm::vec4(glm::vec3(value), 1.0f);
  }
  const common::CameraModel camera = test_support::make_pinhole(kWidth, kHeight, 50.0);
  return meter_exposure(grid, camera, camera,
                        common::ImageRgb8(kWidth, kHeight, common::Rgb8(150)));
}

float grey() {
  return scene::inverse_tone_map(glm::vec3(scene::srgb_decode(std::uint8_t{150})),
                                 scene::tone_map_of(1.0f))
      .x;
}

TEST(ExposureRange, BlackAndInfinitePixelsCountNotAtAll) {
  for (const float unusable :
       {0.0f, -1.0f, std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    for (const int changed : {1, kCount / 2, kCount - 1}) {
      EXPECT_FLOAT_EQ(metered_with(changed, unusable).value(), grey() / kRadiance)
          << changed << " of " << unusable;
    }
    // Beyond: with none left there is no reading, and the last exposure stays.
    EXPECT_FALSE(metered_with(kCount, unusable)) << unusable;
  }
}

TEST(ExposureRange, OutliersCountOnlyWhenTheyAreHalf) {
  for (const float outlier : {1e-6f, 1e-2f, 1e3f}) {
    EXPECT_FLOAT_EQ(metered_with(kCount / 2 - 1, outlier).value(), grey() / kRadiance) << outlier;
    // Beyond: what is more frequent is taken for the model.
    EXPECT_NE(metered_with(kCount / 2 + 1, outlier).value(), grey() / kRadiance) << outlier;
  }
}

TEST(ExposureRange, FollowsTwelveDecadesAndStopsThere) {
  for (float radiance = 1e-5f; radiance < 1e5f; radiance *= 10.0f) {
    EXPECT_FLOAT_EQ(metered_with(0, 0.0f, radiance).value(), grey() / radiance) << radiance;
  }
  EXPECT_EQ(metered_with(0, 0.0f, 1e-30f), 1e6f);
  EXPECT_EQ(metered_with(0, 0.0f, 1e30f), 1e-6f);
}

}  // namespace
}  // namespace amalgam::passes
