// What the client tells a server about the surroundings: a picture and the lens that took it.
#pragma once

#include <filesystem>

#include "protocol/amalgam.pb.h"

namespace amalgam::client {

// image: any picture that OpenCV reads. JPEG that a server takes is passed on byte for byte,
// anything else is made smaller if need be (2048 pixels at most) and encoded anew; a picture of
// more than 8 bits loses what is brighter than white. fisheye: empty for an equirectangular image,
// otherwise an OpenCV file (YAML, JSON, XML) with
//
//   camera_matrix          3x3, pixels for each radian (the equidistant model: r = f * angle)
//   image_width, image_height   optional; the calibration is scaled to the picture's size
//   max_angle_degrees      from the axis, above 0 and at most 180; without it 90
//   world_from_fisheye     unit quaternion x y z w, see PROTOCOL.md; there is no default
//   distortion_coefficients     optional; all 0, as OpenCV's fish-eye model without them is this
//   one
//
// Throws std::runtime_error with one line.
protocol::Envelope load_environment(const std::filesystem::path& image,
                                    const std::filesystem::path& fisheye);

}  // namespace amalgam::client
