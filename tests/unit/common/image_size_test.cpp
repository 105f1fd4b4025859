#include "common/image_size.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::common {
namespace {

TEST(ImageSize, IsTwoSidesWithinTheLimit) {
  EXPECT_EQ(parse_image_size("800x600", 2048), glm::ivec2(800, 600));
  EXPECT_EQ(parse_image_size("1x2048", 2048), glm::ivec2(1, 2048));
  for (const char* bad : {"", "x", "800", "800x", "x600", "0x1", "-1x5", "800x600x", "2049x2",
                          "2x2049", " 8x6", "8x6 ", "8 x6", "99999999999x2"}) {
    EXPECT_THROW(parse_image_size(bad, 2048), std::runtime_error) << bad;
  }
}

}  // namespace
}  // namespace amalgam::common
