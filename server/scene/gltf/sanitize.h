// Makes radiance finite, not negative and at most kMaxRadiance (numerics B16).
#pragma once

#include <cstddef>
#include <string>

#include "common/image.h"

namespace amalgam::scene {

// Number of color components replaced.
struct SanitizeCounts {
  std::size_t nan = 0;        // became 0
  std::size_t infinite = 0;   // +infinity became 65504
  std::size_t negative = 0;   // became 0, -infinity too
  std::size_t too_large = 0;  // finite and over 65504, became 65504

  std::size_t total() const { return nan + infinite + negative + too_large; }
  std::string describe() const;
};

constexpr float kMaxRadiance = 65504.0f;  // the largest half float

SanitizeCounts sanitize_radiance(common::ImageRgb32f& image);

}  // namespace amalgam::scene
