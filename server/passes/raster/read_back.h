// Reads textures back to main memory: images for dumps, and the exposure meter's grid.
#pragma once

#include "common/image.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// All texels of an RGBA32F texture.
common::ImageRgba32f read_rgba(DeviceImage image);

}  // namespace amalgam::passes
