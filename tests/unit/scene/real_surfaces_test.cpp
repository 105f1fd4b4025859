#include "scene/light/real_surfaces.h"

#include <gtest/gtest.h>

namespace amalgam::scene {
namespace {

// A shadow on a cloth whose color the model does not know: by ratio the composite is what the
// camera would have seen.
TEST(RealSurfaces, TheRatioIsRightForAnyAlbedo) {
  for (const ToneCurve curve : kToneCurves) {
    const ToneMap camera = tone_map_of(0.8f, curve);
    const glm::vec3 lit(0.9f), shadowed(0.3f, 0.35f, 0.4f);  // irradiance / pi
    for (const glm::vec3& cloth : {glm::vec3(0.6f, 0.03f, 0.04f), glm::vec3(0.8f)}) {
      const glm::vec3 seen = tone_map(cloth * lit, camera);
      const glm::vec3 truth = tone_map(cloth * shadowed, camera);
      const glm::vec3 model(0.6f);
      const LightChange change =
          light_change(model * shadowed, model * lit, camera, RealSurfaces::Ratio);
      EXPECT_EQ(change.difference, glm::vec3(0.0f));
      const glm::vec3 composite = scale_light(seen, 1.0f + change.relative, curve);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(composite[c], truth[c], 1e-6f);
      const glm::vec3 found =
          change_radiance(cloth * lit, model * shadowed, model * lit, camera, RealSurfaces::Ratio);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], cloth[c] * shadowed[c], 1e-6f);
    }
  }
}

TEST(RealSurfaces, NoChangeChangesNoBit) {
  const glm::vec3 light(0.123f, 4.5e-4f, 0.0f), seen(0.7f, 0.3f, 1.0f);
  for (const RealSurfaces way : {RealSurfaces::Ratio, RealSurfaces::Difference}) {
    const LightChange change = light_change(light, light, {}, way);
    EXPECT_EQ(change.relative, glm::vec3(0.0f));
    EXPECT_EQ(change.difference, glm::vec3(0.0f));
    EXPECT_EQ(change_radiance(seen, light, light, {}, way), seen);
  }
  for (const ToneCurve curve : kToneCurves)
    EXPECT_EQ(scale_light(seen, glm::vec3(1.0f), curve), seen);
}

TEST(RealSurfaces, DifferenceIsTheThesiss) {
  const ToneMap camera = tone_map_of(2.0f);
  const glm::vec3 mixed(0.1f), real(0.5f);
  const LightChange change = light_change(mixed, real, camera, RealSurfaces::Difference);
  EXPECT_EQ(change.relative, glm::vec3(0.0f));
  EXPECT_EQ(change.difference, tone_map(mixed, camera) - tone_map(real, camera));
  EXPECT_EQ(change_radiance(glm::vec3(0.7f), mixed, real, camera, RealSurfaces::Difference),
            glm::vec3(0.7f) + (mixed - real));
  EXPECT_EQ(change_radiance(glm::vec3(0.1f), mixed, real, camera, RealSurfaces::Difference),
            glm::vec3(0.0f));
}

// Where the model sees next to no light the ratio means nothing, and there is no step in between.
TEST(RealSurfaces, TheRatioFadesOutWhereTheModelIsDark) {
  const auto change = [](float real) {
    return light_change(glm::vec3(0.0f), glm::vec3(real), {}, RealSurfaces::Ratio);
  };
  EXPECT_EQ(change(0x1p-11f).relative, glm::vec3(0.0f));
  EXPECT_LT(change(0x1p-11f).difference.x, 0.0f);
  EXPECT_EQ(change(0x1p-7f).relative, glm::vec3(-1.0f));
  EXPECT_EQ(change(0x1p-7f).difference, glm::vec3(0.0f));
  float last = 0.0f;
  for (float real = 0x1p-10f; real < 0x1p-8f; real += 0x1p-16f) {
    const float relative = change(real).relative.x;
    EXPECT_LE(relative, last);
    EXPECT_GT(relative, last - 0.01f);
    last = relative;
  }
  EXPECT_EQ(light_change(glm::vec3(0.0f), glm::vec3(0.0f), {}, RealSurfaces::Ratio).relative,
            glm::vec3(0.0f));
}

TEST(RealSurfaces, WhatIsClippedDarkensFromTheClippingPoint) {
  EXPECT_FLOAT_EQ(scale_light(glm::vec3(1.0f), glm::vec3(0.5f), ToneCurve::Linear).x, 0.5f);
  EXPECT_EQ(scale_light(glm::vec3(0.8f), glm::vec3(2.0f), ToneCurve::Linear).x, 1.0f);
  const float dark = scale_light(glm::vec3(1.0f), glm::vec3(1e-3f), ToneCurve::Reinhard).x;
  EXPECT_GT(dark, 0.0f);
  EXPECT_LT(dark, 0.5f);
}

TEST(RealSurfaces, NamesAreRead) {
  EXPECT_EQ(parse_real_surfaces("ratio"), RealSurfaces::Ratio);
  EXPECT_EQ(parse_real_surfaces("difference"), RealSurfaces::Difference);
  EXPECT_THROW(parse_real_surfaces("Ratio"), std::invalid_argument);
  EXPECT_EQ(parse_tone_curve("linear"), ToneCurve::Linear);
  EXPECT_THROW(parse_tone_curve("gamma"), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::scene
