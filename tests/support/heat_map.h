// A heat map of two pictures' differences as text, for a failing test's output.
#pragma once

#include <string>

#include "common/image.h"

namespace amalgam::test_support {

// At most this many characters; each stands for a cell of N x 2N pixels.
constexpr int kHeatMapWidth = 64, kHeatMapHeight = 24;

// differences: 0 or more; infinity where values cannot be compared, such as NaN. A character shows
// the largest difference of its cell in units of the tolerance (if that is 0, of a tenth of the
// largest finite difference):
//
//     ' ' equal   '.' up to 1/100   ':' up to 1/10   '-' up to 1, which is within tolerance
//     '+' up to 2   '*' up to 5   '#' up to 20   '@' more   '!' infinite
//
// Below the grid follow a legend, the largest difference and its pixel, and the number of pixels
// over the tolerance. Every line ends with a newline.
std::string heat_map(const common::Image<double>& differences, double tolerance);

}  // namespace amalgam::test_support
