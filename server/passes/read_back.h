// From the GPU's memory to ours: images for dumps and for the exposure meter.
#pragma once

#include "core/image.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// All texels of an RGBA32F texture.
core::ImageRgba32f read_rgba(DeviceImage image);

// Every step-th texel in both directions: texel (x, y) of the result is texel
// (x step + step / 2, y step + step / 2) of the image. Blocks that reach beyond the image are left
// out.
core::ImageRgba32f read_rgba_downsampled(DeviceImage image, int step);

}  // namespace amalgam::passes
