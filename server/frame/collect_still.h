// Gathers the results of a frame that equal frames after it may reuse.
#pragma once

#include <optional>

#include "frame/frame_passes.h"
#include "frame/still_frame.h"

namespace amalgam::frame {

// graph: already evaluated. Nothing if the results take more than StillView::kMostBytes.
std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view);

}  // namespace amalgam::frame
