#include "common/image.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::common {
namespace {

TEST(Image, RowsRunFromTheTopLeft) {
  Image<int> image(3, 2, 7);
  image.at(2, 1) = 9;
  EXPECT_EQ(image.pixels().size(), 6u);
  EXPECT_EQ(image.pixels()[5], 9);
  EXPECT_EQ(image.at(0, 0), 7);
  EXPECT_EQ(image.size(), glm::ivec2(3, 2));
}

TEST(Image, EqualityIsOfSizeAndPixels) {
  EXPECT_EQ(Image<int>(2, 3, 1), Image<int>(2, 3, 1));
  EXPECT_NE(Image<int>(2, 3, 1), Image<int>(3, 2, 1));
  EXPECT_NE(Image<int>(2, 3, 1), Image<int>(2, 3, 2));
  EXPECT_TRUE(Image<int>().empty());
}

TEST(Image, ImpossibleSizesAreRefusedBeforeAllocating) {
  EXPECT_THROW(ImageRgb8(-1, 5), std::invalid_argument);
  EXPECT_THROW(ImageRgb8(5, -1), std::invalid_argument);
  EXPECT_THROW(ImageRgb8(65500, 65500), std::invalid_argument);
  EXPECT_THROW(checked_pixel_count(2147483647, 2147483647), std::invalid_argument);
  EXPECT_EQ(checked_pixel_count(0, 100), 0u);
}

}  // namespace
}  // namespace amalgam::common
