// Reads a camera's calibration, so that poses and rendering use the camera's real lens.
//
// calibration_file.h lists the kinds of files: a 3x3 camera matrix (pixels), 0 to 14 distortion
// coefficients in OpenCV's order (the two of a tilted sensor must be 0), optionally the image's
// size (pixels). Errors are std::runtime_error with one line.
#pragma once

#include <filesystem>

#include "common/camera_model.h"

namespace amalgam::client {

// Width and height of the result are 0 if the file does not state them: see fit_to_image().
common::CameraModel load_calibration(const std::filesystem::path& file);

// The calibration for images of this size (pixels). A calibration without a size takes the image's.
// One of another size is scaled, with a warning in the log, if the aspect ratio is the same to
// within one pixel; otherwise throws. Also throws if the resulting camera cannot be rendered with.
common::CameraModel fit_to_image(const common::CameraModel& calibration, int width, int height);

}  // namespace amalgam::client
