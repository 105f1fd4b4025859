// What a frame leaves for equal ones after it.
#pragma once

#include <optional>

#include "frame/frame_passes.h"
#include "frame/still_frame.h"

namespace amalgam::frame {

// Of a graph that has been evaluated. Nothing if it would take more than StillView::kMostBytes.
std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view);

}  // namespace amalgam::frame
