#include "scene/gltf/environment_loader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "codec/exr.h"
#include "scene/gltf/sanitize.h"
#include "scene/light/tone_map.h"
#include "scene/scene_error.h"
#include "support/test_data.h"

namespace amalgam::scene {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// numerics B16.
TEST(Sanitize, ReplacesAndCountsExactly) {
  common::ImageRgb32f image(3, 2, glm::vec3(1.0f));
  image.at(0, 0) = {kInfinity, kNan, -1.0f};
  image.at(1, 0) = {1e38f, 1e-40f, -kInfinity};
  image.at(2, 0) = {65504.0f, 65505.0f, -0.0f};
  const SanitizeCounts counts = sanitize_radiance(image);
  EXPECT_EQ(counts.nan, 1u);
  EXPECT_EQ(counts.infinite, 1u);
  EXPECT_EQ(counts.negative, 2u);
  EXPECT_EQ(counts.too_large, 2u);
  EXPECT_EQ(counts.total(), 6u);
  EXPECT_EQ(image.at(0, 0), glm::vec3(65504.0f, 0.0f, 0.0f));
  EXPECT_EQ(image.at(1, 0), glm::vec3(65504.0f, 1e-40f, 0.0f));
  EXPECT_EQ(image.at(2, 0), glm::vec3(65504.0f, 65504.0f, 0.0f));
  EXPECT_EQ(image.at(1, 1), glm::vec3(1.0f));
  EXPECT_EQ(sanitize_radiance(image).total(), 0u);
}

TEST(EnvironmentLoader, HighDynamicRangeIsSanitisedAndNoted) {
  const auto path = std::filesystem::path(testing::TempDir()) / "amalgam_hostile.exr";
  common::ImageRgb32f image(2, 1, glm::vec3(0.5f));
  image.at(1, 0).y = kNan;
  codec::write_exr(path, image);
  std::vector<std::string> notes;
  const Environment environment = load_environment(path, notes);
  EXPECT_FALSE(environment.low_dynamic_range);
  EXPECT_EQ(environment.radiance.at(1, 0), glm::vec3(0.5f, 0.0f, 0.5f));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("1 NaN"), std::string::npos);
}

TEST(EnvironmentLoader, LowDynamicRangeIsDisplayLinear) {
  common::ImageRgba8 picture(1, 1, common::Rgba8(0, 128, 255, 255));
  const Environment environment = environment_from_ldr(picture);
  EXPECT_TRUE(environment.low_dynamic_range);
  EXPECT_EQ(environment.radiance.at(0, 0), srgb_decode(common::Rgb8(0, 128, 255)));
}

TEST(EnvironmentLoader, RefusalsNameTheFile) {
  std::vector<std::string> notes;
  const std::filesystem::path folder(testing::TempDir());
  std::ofstream(folder / "amalgam_junk.exr") << "junk";
  std::ofstream(folder / "amalgam_junk.jpg") << "junk";
  std::ofstream(folder / "amalgam_junk.txt") << "junk";
  for (const char* name :
       {"amalgam_junk.exr", "amalgam_junk.jpg", "amalgam_junk.txt", "missing.exr"}) {
    try {
      load_environment(folder / name, notes);
      ADD_FAILURE() << name;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

// A mirror ball or a cross is no latitude-longitude map, and no file says what it is.
TEST(EnvironmentLoader, OtherShapesAreNoted) {
  const auto path = std::filesystem::path(testing::TempDir()) / "amalgam_square.exr";
  codec::write_exr(path, common::ImageRgb32f(8, 8, glm::vec3(1.0f)));
  std::vector<std::string> notes;
  load_environment(path, notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("8x8 is not twice as wide"), std::string::npos);
}

TEST(EnvironmentLoader, HostileMapsBecomeFinite) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  for (const char* name : {"AllHalfValues.exr", "BrightRingsNanInf.exr", "WideFloatRange.exr"}) {
    std::vector<std::string> notes;
    const Environment environment =
        load_environment(*data / "envmaps" / "openexr-images" / name, notes);
    EXPECT_NE(notes.at(0).find("replaced"), std::string::npos) << name;
    for (const glm::vec3& texel : environment.radiance.pixels()) {
      for (int i = 0; i < 3; ++i) ASSERT_TRUE(texel[i] >= 0.0f && texel[i] <= kMaxRadiance) << name;
    }
  }
}

TEST(EnvironmentLoader, JpegMapsAreLowDynamicRange) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  std::vector<std::string> notes;
  const Environment environment =
      load_environment(*data / "envmaps" / "ldr" / "StageEnvLatLong_ldr.jpg", notes);
  EXPECT_TRUE(environment.low_dynamic_range);
  EXPECT_GT(environment.radiance.width(), 100);
}

}  // namespace
}  // namespace amalgam::scene
