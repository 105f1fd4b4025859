// A frame's stages, summed as the goals ask for them. Names are those of FrameStatistics::stages.
#pragma once

#include <string_view>

#include "core/timings.h"

namespace amalgam::bench {

// Throws std::runtime_error if the stage did not run: a ratio to it would mean nothing.
double stage_milliseconds(const core::StageTimes& stages, std::string_view name);

// Everything but the tracer, the codecs and what runs only when something moved.
double raster_milliseconds(const core::StageTimes& stages);

// All stages of the frame.
double sum_of_stages(const core::StageTimes& stages);

}  // namespace amalgam::bench
