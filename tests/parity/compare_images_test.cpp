// The comparison that the parity and golden tests rely on.
#include "support/compare_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace amalgam::test_support {
namespace {

const Tolerance kNone = {0.0, 0.0, "the same image"};

TEST(CompareImages, SameImagesHaveNoDifference) {
  const common::ImageRgb32f image(3, 2, glm::vec3(0.5f));
  const ImageComparison comparison = compare_images(image, image);
  EXPECT_TRUE(comparison.within(kNone));
  EXPECT_EQ(comparison.compared, 6u);
  EXPECT_TRUE(comparison.worst.empty());
}

TEST(CompareImages, FindsTheWorstPixelAndTheMean) {
  const common::ImageRgb32f expected(4, 2, glm::vec3(2.0f));
  common::ImageRgb32f actual = expected;
  actual.at(1, 1) = {2.0f, 1.5f, 2.25f};
  actual.at(3, 0) = {2.0f, 2.0f, 2.25f};
  const ImageComparison absolute = compare_images(actual, expected);
  EXPECT_DOUBLE_EQ(absolute.maximum, 0.5);
  EXPECT_DOUBLE_EQ(absolute.mean, 0.75 / 8.0);
  EXPECT_EQ(absolute.worst.front().x, 1);
  EXPECT_EQ(absolute.worst.front().y, 1);
  EXPECT_FALSE(absolute.within({0.4, 1.0, ""}));
  EXPECT_FALSE(absolute.within({1.0, 0.01, ""}));
  const ImageComparison relative = compare_images(actual, expected, {.relative_floor = 0.1});
  EXPECT_DOUBLE_EQ(relative.maximum, 0.25);
}

TEST(CompareImages, LeavesOutWhatIsNotIncluded) {
  const common::ImageRgb32f expected(2, 1, glm::vec3(0.0f));
  common::ImageRgb32f actual = expected;
  actual.at(0, 0) = glm::vec3(9.0f);
  common::Image<std::uint8_t> include(2, 1, 1);
  include.at(0, 0) = 0;
  const ImageComparison comparison = compare_images(actual, expected, {.include = &include});
  EXPECT_TRUE(comparison.within(kNone));
  EXPECT_EQ(comparison.compared, 1u);
}

TEST(CompareImages, NotANumberCannotHide) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const common::ImageRgb32f good(2, 2, glm::vec3(1.0f));
  for (const float bad : {nan, infinity, -infinity}) {
    common::ImageRgb32f image = good;
    image.at(1, 0).g = bad;
    const Tolerance generous = {1e30, 1e30, "everything finite"};
    EXPECT_FALSE(compare_images(image, good).within(generous));
    EXPECT_FALSE(compare_images(good, image).within(generous));
    EXPECT_FALSE(compare_images(image, image).within(generous));  // not even the same one
  }
}

TEST(CompareImages, WritesWhatFailed) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "amalgam-compare-images-test";
  std::filesystem::remove_all(folder);
  const common::ImageRgb32f black(2, 2, glm::vec3(0.0f)), white(2, 2, glm::vec3(1.0f));
  EXPECT_EQ(check_images("same", white, white, kNone, folder), "");
  EXPECT_FALSE(std::filesystem::exists(folder));
  const std::string text = check_images("other", white, black, kNone, folder);
  EXPECT_NE(text.find("other: maximum 1"), std::string::npos) << text;
  EXPECT_NE(text.find("the same image"), std::string::npos) << text;
  for (const char* kind : {"actual", "expected", "difference"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "failed-images" /
                                        (std::string("other-") + kind + ".exr")));
  }
  std::filesystem::remove_all(folder);
}

TEST(CompareImages, RefusesDifferentSizes) {
  EXPECT_THROW(compare_images(common::ImageRgb32f(2, 2), common::ImageRgb32f(2, 3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::test_support
