#include "codec/exr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/test_data.h"

namespace amalgam::codec {
namespace {

class Exr : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const {
    return std::filesystem::path(testing::TempDir()) / ("amalgam_exr_" + name);
  }
};

TEST_F(Exr, RgbSurvivesExactly) {
  common::ImageRgb32f image(5, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const glm::vec2 p(x, y);
      image.at(x, y) = glm::vec3(p.x * 1000.1f, -1.0f / (p.y + 1.0f), 1e-30f * p.x);
    }
  }
  write_exr(file("rgb.exr"), image);
  EXPECT_EQ(read_exr(file("rgb.exr")), image);
}

TEST_F(Exr, ChannelsKeepTheirNamesAndHostileValues) {
  common::Image32f depth(2, 2, std::numeric_limits<float>::infinity()), mask(2, 2, 1.0f);
  mask.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
  write_exr(file("named.exr"), {{"depth", depth}, {"mask", mask}});
  const auto channels = read_exr_channels(file("named.exr"));
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels.at("depth"), depth);
  EXPECT_TRUE(std::isnan(channels.at("mask").at(1, 0)));
  EXPECT_THROW(read_exr(file("named.exr")), ExrError);  // no R, G, B, Y
}

TEST_F(Exr, SingleChannelIsLuminanceAndAlphaIsKept) {
  write_exr(file("y.exr"), common::Image32f(3, 2, 0.25f));
  EXPECT_EQ(read_exr(file("y.exr")), common::ImageRgb32f(3, 2, glm::vec3(0.25f)));
  write_exr(file("rgba.exr"), common::ImageRgba32f(3, 2, glm::vec4(1, 2, 3, 4)));
  EXPECT_EQ(read_exr_channels(file("rgba.exr")).at("A"), common::Image32f(3, 2, 4.0f));
}

TEST_F(Exr, ErrorsNameTheFile) {
  try {
    read_exr(file("missing.exr"));
    FAIL();
  } catch (const ExrError& error) {
    EXPECT_NE(std::string(error.what()).find("missing.exr"), std::string::npos);
  }
  EXPECT_THROW(write_exr("/nonexistent/folder/a.exr", common::Image32f(1, 1)), ExrError);
  EXPECT_THROW(write_exr(file("empty.exr"), common::Image32f()), ExrError);
  EXPECT_THROW(
      write_exr(file("sizes.exr"), {{"a", common::Image32f(1, 1)}, {"b", common::Image32f(2, 1)}}),
      ExrError);
}

TEST_F(Exr, EnvironmentMapsOfAllKindsAreRead) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*data / "envmaps")) {
    if (entry.path().extension() != ".exr") continue;
    EXPECT_FALSE(read_exr(entry.path()).empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 16);
}

TEST_F(Exr, DamagedFilesAreReadOrRefused) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int refused = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(*data / "robustness" / "exr_openexr_tests")) {
    if (entry.path().extension() != ".exr") continue;
    try {
      read_exr_channels(entry.path());
    } catch (const ExrError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GE(refused, 5);
}

}  // namespace
}  // namespace amalgam::codec
