// Where the light of a whole frame came from, put together from the passes that made it.
#pragma once

#include <optional>

#include "core/provenance.h"
#include "frame/frame_passes.h"

namespace amalgam::frame {

// What was rasterised, from the mask; what was traced, from the tracer; and where a pixel was taken
// again, the refinement's shares instead of both. Needs TraceInputs::keep_provenance. Nothing if
// nothing was drawn.
std::optional<core::ProvenanceImage> frame_provenance(const graph::FrameGraph& graph,
                                                      const FramePasses& frame,
                                                      const passes::RenderView& view);

}  // namespace amalgam::frame
