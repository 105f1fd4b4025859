// Traces the samples that the rasteriser cannot draw: mirrors and glass (sections 4.2 to 4.4).
//
// A tile of pixels is one task with its own queues of work items; its loop is a list of verbs over
// them. Sums are made in a fixed order, so images are bit-equal for any number of threads (numerics
// B25).
#pragma once

#include "trace/trace_request.h"

namespace amalgam::trace {

// Runs on the caller's TBB arena.
TraceResult trace(const TraceRequest& request);

// The result of tracing again, to the bit, if only the camera image and the exposure have changed
// since the paths were kept. Casts no ray. Makes no images and no provenance.
TraceResult look_up_again(const TracedPaths& paths, const common::ImageRgb8& camera_image,
                          const scene::ToneMap& tone_map, scene::RealSurfaces real_surfaces);

}  // namespace amalgam::trace
