// OpenEXR's cube maps: six square faces, one below the other. For this folder only.
#pragma once

#include <optional>

#include "common/image.h"

namespace amalgam::codec {

// The same light on an equirectangular map in OpenEXR's latitude-longitude orientation, four faces
// wide; nothing unless the image is six times as high as wide. Bilinear: the outermost pixels of a
// face lie on its edges, so that no look-up needs two faces.
std::optional<common::ImageRgb32f> equirectangular_from_cube(const common::ImageRgb32f& cube);

}  // namespace amalgam::codec
