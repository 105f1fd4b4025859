// Gathers a finished frame's buffers for a dump: what was made anyway, nothing more is run for it.
#pragma once

#include "frame/buffer_dump.h"
#include "frame/frame_passes.h"

namespace amalgam::frame {

FrameBuffers collect_buffers(const graph::FrameGraph& graph, const FramePasses& frame,
                             const passes::RenderView& view);

}  // namespace amalgam::frame
