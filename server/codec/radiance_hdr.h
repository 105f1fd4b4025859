// Radiance pictures (.hdr, .pic): G. Ward's RGBE format, as its manual "filefmts" and
// ray/src/common of Radiance define it.
//
// Not stb_image's reader: it loops without end on truncated files, reads the older run lengths as
// pixels and ignores the exposure.
#pragma once

#include <cstddef>
#include <span>

#include "codec/picture.h"
#include "common/image.h"

namespace amalgam::codec {

// Scene-linear Rec. 709. Pixels are plain, with the older run lengths (pixels 1 1 1 n) or with run
// lengths by component, in any of the eight orders of the size line. EXPOSURE and COLORCORR are
// divided out. XYZE, and RGBE with PRIMARIES, are converted. A mantissa m stands for m / 256, as
// other programs read it, and not for (m + 0.5) / 256, as Radiance does. Time is linear in the
// bytes and pixels. Throws PictureError.
common::ImageRgb32f decode_radiance_hdr(std::span<const std::byte> encoded);

}  // namespace amalgam::codec
