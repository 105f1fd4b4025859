// Adds the rasterised and the traced layers (eq. 4.1, 4.2).
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "trace/tracer.h"

namespace amalgam::passes {

struct MergeInputs {
  // Either may be absent, but not both.
  graph::Handle<Layers> rasterised;
  graph::Handle<trace::TraceResult> traced;
};

// Absent if all layers are zero everywhere: "nothing virtual has an effect on this frame".
graph::Handle<Layers> add_merge_pass(graph::FrameGraph& graph, const MergeInputs& in);

}  // namespace amalgam::passes
