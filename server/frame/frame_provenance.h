// Puts a frame's provenance together from its passes.
#pragma once

#include <optional>

#include "core/provenance.h"
#include "frame/frame_passes.h"

namespace amalgam::frame {

// Rasterised samples from the mask, traced ones from the tracer; for refined pixels, the
// refinement's shares replace both. Needs TraceInputs::keep_provenance. Nothing if nothing was
// drawn.
std::optional<core::ProvenanceImage> frame_provenance(const graph::FrameGraph& graph,
                                                      const FramePasses& frame,
                                                      const passes::RenderView& view);

}  // namespace amalgam::frame
