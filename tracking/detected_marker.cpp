#include "tracking/detected_marker.h"

#include <cmath>

namespace amalgam::tracking {

double area(const SquareCorners& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

}  // namespace amalgam::tracking
