// Reads a camera's calibration, so that poses and rendering use the camera's real lens.
//
// Files are OpenCV's (YAML, XML or JSON as cv::FileStorage reads them): camera_matrix (3x3,
// pixels), distortion_coefficients (0 to 14 numbers in OpenCV's order; the two of a tilted sensor
// must be 0), optionally image_width and image_height (pixels). Errors are std::runtime_error with
// one line.
#pragma once

#include <filesystem>

#include "common/camera_model.h"

namespace amalgam::client {

// Width and height of the result are 0 if the file does not state them: see fit_to_image().
common::CameraModel load_calibration(const std::filesystem::path& file);

// The calibration for images of this size (pixels). A calibration without a size takes the image's.
// One of another size is scaled if the aspect ratio is the same to within one pixel; otherwise
// throws. Also throws if the resulting camera cannot be rendered with.
common::CameraModel fit_to_image(const common::CameraModel& calibration, int width, int height);

}  // namespace amalgam::client
