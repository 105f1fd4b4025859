// A marker found in an image, without a pose.
#pragma once

#include "tracking/square_pose.h"

namespace amalgam::tracking {

struct DetectedMarker {
  int id = 0;
  SquareCorners corners{};
};

// Area of the quadrilateral in the image, square pixels.
double area(const SquareCorners& corners);

}  // namespace amalgam::tracking
