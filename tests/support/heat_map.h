// Where two pictures differ, as text: a failing test shows it in the terminal.
#pragma once

#include <string>

#include "common/image.h"

namespace amalgam::test_support {

// At most this many characters; each stands for a cell of N x 2N pixels.
constexpr int kHeatMapWidth = 64, kHeatMapHeight = 24;

// Differences of one picture, of at least 0; infinity where there is nothing to compare, as with
// NaN. A character says the largest difference of its cell, in steps of the tolerance (of a tenth
// of the largest finite difference where the tolerance is 0):
//
//     ' ' equal   '.' up to 1/100   ':' up to 1/10   '-' up to 1, which is within tolerance
//     '+' up to 2   '*' up to 5   '#' up to 20   '@' more   '!' infinite
//
// Below the grid stand what the characters mean, the largest difference and its pixel, and how many
// pixels are over the tolerance. Every line ends with a newline.
std::string heat_map(const common::Image<double>& differences, double tolerance);

}  // namespace amalgam::test_support
