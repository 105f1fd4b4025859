// Traces the samples that the rasteriser cannot draw: what mirrors and glass show (sections 4.2
// to 4.4).
//
// A tile of pixels is one task that owns its queues; its loop is a list of verbs over work items.
// Sums are made in a fixed order, so images are bit-equal for any number of threads (numerics B25).
#pragma once

#include "trace/trace_request.h"

namespace amalgam::trace {

// Runs on the caller's TBB arena.
TraceResult trace(const TraceRequest& request);

// The same result, to the bit, as tracing again where only the camera image and the exposure have
// changed since the paths were kept. No ray is cast. Images and provenance are not made.
TraceResult look_up_again(const TracedPaths& paths, const common::ImageRgb8& camera_image,
                          float exposure);

}  // namespace amalgam::trace
