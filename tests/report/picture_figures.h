// How far a composite is from the reference's, in display-linear light: 1 is white.
#pragma once

#include <cstdint>

#include "common/image.h"

namespace amalgam::report {

struct PictureFigures {
  double mae = 0.0;             // mean absolute error
  double mse = 0.0;             // mean square error
  double mrse = 0.0;            // mean of (v - ref)^2 / (ref + 0.01)^2
  double ssim = 1.0;            // of the pictures as bytes
  double psnr = 0.0;            // likewise, decibels
  double maximum = 0.0;         // largest absolute error
  std::uint64_t nonfinite = 0;  // values; each counts as the end of [0, 1] that is further off
};

// Means are over all pixels and channels. Throws std::invalid_argument if the sizes differ.
PictureFigures picture_figures(const common::ImageRgb32f& actual,
                               const common::ImageRgb32f& expected);

double mean_absolute_error(const common::ImageRgb32f& actual, const common::ImageRgb32f& expected);

// sRGB-encoded.
common::ImageRgb8 as_bytes(const common::ImageRgb32f& display_linear);
common::ImageRgb32f as_light(const common::ImageRgb8& bytes);

}  // namespace amalgam::report
