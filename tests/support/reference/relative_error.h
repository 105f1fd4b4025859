// How far two colors are apart in relation to the one that is taken for right.
#pragma once

#include <cmath>

#include "support/reference/vectors.h"

namespace amalgam::reference {

// What is darker than this is measured in relation to this: scene-linear, at exposure 1 a hundredth
// of display-linear white.
constexpr double kDarkest = 0.01;

// Of the worst channel. NaN and infinity count as infinitely wrong.
inline double relative_error(const Color& actual, const Color& expected) {
  double worst = 0.0;
  for (glm::length_t c = 0; c < 3; ++c) {
    const double error =
        std::abs(actual[c] - expected[c]) / std::max(kDarkest, std::abs(expected[c]));
    worst = std::max(worst, std::isfinite(error) ? error : kInfinity);
  }
  return worst;
}

}  // namespace amalgam::reference
