// How far a picture may be from the one without a depth limit and an importance cut-off.
#pragma once

#include <algorithm>

namespace amalgam::core {

// An upper bound in display-linear light, of a picture or of a part of one.
struct TruncationBound {
  double sum = 0.0;    // over pixels, of the mean of a pixel's three channels
  double worst = 0.0;  // of all pixels and channels

  TruncationBound& operator+=(const TruncationBound& other) {
    sum += other.sum;
    worst = std::max(worst, other.worst);
    return *this;
  }
};

}  // namespace amalgam::core
