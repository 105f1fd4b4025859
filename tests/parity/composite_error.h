// How far apart two frames' composites are before they are rounded to bytes.
#pragma once

#include "common/image.h"
#include "frame/buffer_dump.h"

namespace amalgam::parity {

struct Error {
  double mean = 0.0;   // over pixels and channels, display-linear
  double worst = 0.0;  // of any pixel and channel
};

// Buffers of the same camera, whose lens does not distort. image: the camera's.
Error composite_error(const common::ImageRgb8& image, const frame::FrameBuffers& a,
                      const frame::FrameBuffers& b);

}  // namespace amalgam::parity
