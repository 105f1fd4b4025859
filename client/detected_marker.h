// A marker as it is found in an image, before anything is known of where it is.
#pragma once

#include "client/square_pose.h"

namespace amalgam::client {

struct DetectedMarker {
  int id = 0;
  SquareCorners corners{};
};

// Of the quadrilateral in the image, square pixels.
double area(const SquareCorners& corners);

}  // namespace amalgam::client
