// Two pictures side by side: how far apart, and where. NaN and infinity cannot hide: they count as
// infinitely wrong.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/image.h"

namespace amalgam::test_support {

// What a comparison allows, and why it allows that.
struct Tolerance {
  double maximum = 0.0;
  double mean = 0.0;
  std::string reason;
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

// An empty string if within tolerance. Otherwise what is wrong, and NAME-actual.exr,
// NAME-expected.exr and NAME-difference.exr are written to folder/failed-images.
std::string check_images(const std::string& name, const common::ImageRgb32f& actual,
                         const common::ImageRgb32f& expected, const Tolerance& tolerance,
                         const std::filesystem::path& folder, const CompareOptions& options = {});

// Bytes as numbers from 0 to 255.
common::ImageRgb32f as_floats(const common::ImageRgb8& image);

}  // namespace amalgam::test_support
