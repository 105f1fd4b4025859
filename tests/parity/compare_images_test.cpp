// The comparison that the parity and golden tests rely on.
#include "support/compare_images.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "codec/exr.h"
#include "support/test_output.h"

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

TEST(CompareImages, SetsAsideAFewPixelsAndNoMore) {
  const common::ImageRgb32f expected(10, 1, glm::vec3(0.0f));
  common::ImageRgb32f actual(10, 1, glm::vec3(0.25f));
  actual.at(3, 0) = actual.at(4, 0) = glm::vec3(9.0f);
  const ImageComparison comparison = compare_images(actual, expected);
  EXPECT_TRUE(comparison.within({0.5, 0.25, "", 2}));
  EXPECT_FALSE(comparison.within({0.5, 0.25, "", 1}));
  EXPECT_FALSE(comparison.within({0.5, 0.2, "", 2}));  // the mean of the other eight
  actual.at(3, 0).r = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(compare_images(actual, expected).within({0.5, 0.25, "", 2}));
}

TEST(CompareImages, WritesWhatFailedAndRemovesItWhenItNoLongerFails) {
  const std::filesystem::path folder = test_output_folder();
  EXPECT_TRUE(folder.string().ends_with(
      "/test_output/CompareImages.WritesWhatFailedAndRemovesItWhenItNoLongerFails"));
  std::filesystem::remove_all(folder);
  common::ImageRgb32f black(6, 2, glm::vec3(0.0f)), white(6, 2, glm::vec3(1.0f));
  white.at(5, 1).g = 3.0f;
  EXPECT_TRUE(images_agree("same", white, white, kNone));
  EXPECT_FALSE(std::filesystem::exists(folder));

  const testing::AssertionResult result = images_agree("other", white, black, kNone);
  EXPECT_FALSE(result);
  const std::string text = result.message();
  EXPECT_NE(text.find("other: maximum 3"), std::string::npos) << text;
  EXPECT_NE(text.find("the same image"), std::string::npos) << text;
  EXPECT_NE(text.find("at (5, 1); 12 of 12 pixels"), std::string::npos) << text;
  for (const char* kind : {"actual", "expected", "difference"}) {
    const std::filesystem::path file = folder / (std::string("other-") + kind + ".png");
    EXPECT_NE(text.find(file.string()), std::string::npos) << text;
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
  }
  EXPECT_EQ(codec::read_exr(folder / "other-actual.exr"), white);
  EXPECT_EQ(codec::read_exr(folder / "other-expected.exr"), black);
  EXPECT_EQ(codec::read_exr(folder / "other-difference.exr"), white);

  EXPECT_TRUE(images_agree("other", white, white, kNone));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(CompareImages, PicturesOfFailuresCanBeLookedAt) {
  common::ImageRgb32f expected(3, 1, glm::vec3(0.0f));
  expected.at(1, 0) = {200.0f, 100.0f, 0.0f};
  common::ImageRgb32f actual = expected;
  actual.at(0, 0).b = 10.0f;
  actual.at(2, 0).r = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(images_agree("values", actual, expected, {1.0, 1.0, ""}));
  const auto pixel = [&](const char* kind, int x) {
    const auto path = test_output_folder() / (std::string("values-") + kind + ".png");
    const auto bgr = cv::imread(path.string()).at<cv::Vec3b>(0, x);
    return std::array<int, 3>{bgr[2], bgr[1], bgr[0]};
  };
  using Rgb = std::array<int, 3>;
  EXPECT_EQ(pixel("expected", 1), (Rgb{255, 128, 0}));  // white is 200
  EXPECT_EQ(pixel("expected", 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel("actual", 2), (Rgb{255, 0, 255}));
  EXPECT_EQ(pixel("difference", 0), (Rgb{0, 0, 128}));  // white is 20 times the tolerance
  EXPECT_EQ(pixel("difference", 1), (Rgb{0, 0, 0}));
  std::filesystem::remove_all(test_output_folder());
}

TEST(CompareImages, RefusesDifferentSizes) {
  EXPECT_THROW(compare_images(common::ImageRgb32f(2, 2), common::ImageRgb32f(2, 3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::test_support
