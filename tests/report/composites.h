// A rendered frame as the two pictures whose errors are told apart: before and after JPEG.
#pragma once

#include "bench/render_rig.h"
#include "common/image.h"
#include "frame/frame.h"

namespace amalgam::report {

struct Composites {
  common::ImageRgb32f before_jpeg;  // the float composite, display-linear
  common::ImageRgb32f after_jpeg;   // as the client decodes it
  frame::FrameStatistics statistics;
};

// camera_image: the input's, decoded. render_scale: of the rig's settings.
Composites render_composites(bench::RenderRig& rig, const frame::FrameInput& input,
                             const common::ImageRgb8& camera_image, float render_scale);

// Of a case's first frame; throws codec::JpegError.
common::ImageRgb8 camera_image_of(const frame::FrameInput& input);

// What the renderer meters for a case by default. Both renderers are then given it.
float metered_exposure(const bench::BenchCase& bench_case);

}  // namespace amalgam::report
