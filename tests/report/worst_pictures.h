// A worst case as three pictures: ours, the reference, and where they differ.
#pragma once

#include <string>

#include "common/image.h"

namespace amalgam::report {

constexpr float kDifferenceGain = 10.0f;

// sRGB-encoded.
std::string as_png(const common::ImageRgb8& image);

// The absolute difference, times the gain; what is not finite is white.
common::ImageRgb8 difference_picture(const common::ImageRgb32f& actual,
                                     const common::ImageRgb32f& expected);

}  // namespace amalgam::report
