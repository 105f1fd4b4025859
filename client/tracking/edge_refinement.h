// Moves a found marker's corners to the intersections of its edges, to a few hundredths of a pixel.
//
// OpenCV's refinement searches each corner's neighbourhood, where blur rounds the corner off. It
// ends about an eighth of a pixel inside, which at half a metre is 2 mm along the line of sight.
// Here each of the four edges is measured along its length and fitted by a line.
#pragma once

#include <opencv2/core/mat.hpp>

#include "tracking/square_pose.h"

namespace amalgam::client {

// grey: 8 bits. bits: of the marker's pattern along a side, without its border of one bit. Corners
// that cannot be improved (weak edges, or a result further away than half a bit, and than 1.5
// pixels) are unchanged.
tracking::SquareCorners refine_corners(const cv::Mat& grey, int bits,
                                       const tracking::SquareCorners& corners);

}  // namespace amalgam::client
