// Two pictures side by side: how far apart, and where. NaN and infinity cannot hide: they count as
// infinitely wrong.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "common/image.h"

namespace amalgam::test_support {

// What a comparison allows, and why it allows that.
struct Tolerance {
  double maximum = 0.0;
  double mean = 0.0;  // of the pixels that are not set aside
  std::string reason;
  // So many pixels may differ by more than the maximum, but not infinitely, and are set aside: for
  // edges, on whose other side a sample may fall.
  std::size_t set_aside = 0;
};

struct PixelDifference {
  int x = 0, y = 0;
  double difference = 0.0;  // of the worst channel
  glm::vec3 actual{0.0f}, expected{0.0f};
};

struct ImageComparison {
  double maximum = 0.0;  // over compared pixels; infinity if something is not finite
  double mean = 0.0;
  std::size_t compared = 0;            // pixels
  std::vector<PixelDifference> worst;  // the ten worst, the worst first
  common::Image<double> differences;   // 0 where pixels are left out

  bool within(const Tolerance& tolerance) const;
  std::string describe() const;  // several lines
};

struct CompareOptions {
  // 0: absolute differences. Otherwise relative to the expected value, or to this if that is less.
  double relative_floor = 0.0;
  // Pixels that are 0 here are left out; null: none are.
  const common::Image<std::uint8_t>* include = nullptr;
};

// Throws std::invalid_argument if the sizes differ.
ImageComparison compare_images(const common::ImageRgb32f& actual,
                               const common::ImageRgb32f& expected,
                               const CompareOptions& options = {});

// For EXPECT_TRUE: success if within tolerance. Otherwise says what is wrong and shows what
// show_failure() shows.
testing::AssertionResult images_agree(const std::string& name, const common::ImageRgb32f& actual,
                                      const common::ImageRgb32f& expected,
                                      const Tolerance& tolerance,
                                      const CompareOptions& options = {});

// Likewise for pictures that must be equal to the bit (0 is -0).
testing::AssertionResult images_are_same(const std::string& name, const common::ImageRgb32f& actual,
                                         const common::ImageRgb32f& expected);
testing::AssertionResult images_are_same(const std::string& name, const common::ImageRgb8& actual,
                                         const common::ImageRgb8& expected);

// For a comparison of another kind that has failed: a heat map of its differences, and expected,
// actual and difference pictures in test_output/TEST of the build folder (support/test_output.h).
std::string show_failure(const std::string& name, const common::ImageRgb32f& actual,
                         const common::ImageRgb32f& expected,
                         const common::Image<double>& differences, double tolerance);

// Bytes as numbers from 0 to 255; numbers of another type as float.
common::ImageRgb32f as_floats(const common::ImageRgb8& image);
common::ImageRgb32f as_floats(const common::Image<glm::dvec3>& image);

}  // namespace amalgam::test_support
