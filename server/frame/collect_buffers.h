// Gathers the buffers of a finished frame for a dump. Runs no further pass.
#pragma once

#include "frame/buffer_dump.h"
#include "frame/frame_passes.h"

namespace amalgam::frame {

FrameBuffers collect_buffers(const graph::FrameGraph& graph, const FramePasses& frame,
                             const passes::RenderView& view);

}  // namespace amalgam::frame
