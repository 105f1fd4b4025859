// The renderer's picture of a parity case, with its buffers.
#pragma once

#include "frame/frame_renderer.h"
#include "parity/parity_case.h"

namespace amalgam::parity {

struct Rendering {
  frame::FrameBuffers buffers;
  common::ImageRgb8 composite;
  frame::FrameStatistics statistics;
};

// The case says the exposure, the samples and the Fresnel model; settings say the rest.
Rendering render(const ParityCase& parity_case, const frame::RendererSettings& settings);

// Wall-clock milliseconds from the camera's pixels to the composite's, the median of five frames
// after the first.
double median_frame_time(const ParityCase& parity_case, const frame::RendererSettings& settings);

const char* mode_name(frame::RendererMode mode);

}  // namespace amalgam::parity
