// Makes the message about the client's surroundings: a picture and the lens that took it.
#pragma once

#include <filesystem>

#include "protocol/amalgam.pb.h"

namespace amalgam::client {

// image: any picture that OpenCV reads. A JPEG that a server accepts is passed on byte for byte.
// Others are scaled down if necessary (2048 pixels at most) and encoded; pictures of more than 8
// bits are clipped at white. fisheye: empty for an equirectangular image, otherwise an OpenCV file
// (YAML, JSON, XML) with
//
//   camera_matrix              3x3, pixels for each radian (the equidistant model: r = f * angle)
//   image_width, image_height  optional; the calibration is scaled to the picture's size
//   max_angle_degrees          from the axis, above 0 and at most 180; 90 if left out
//   world_from_fisheye         unit quaternion x y z w, see PROTOCOL.md; required
//   distortion_coefficients    optional; all 0, since the equidistant model has none
//
// Throws std::runtime_error with one line.
protocol::Envelope load_environment(const std::filesystem::path& image,
                                    const std::filesystem::path& fisheye);

}  // namespace amalgam::client
