// The shadow maps' coarse picture of virtual casters, as the tracer asks it before a shadow ray.
#pragma once

#include <memory>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/shadow_maps.h"

namespace amalgam::passes {

graph::Handle<VirtualShadows> add_shadow_bound_pass(graph::FrameGraph& graph,
                                                    const ShadowMapOutputs& shadows);

}  // namespace amalgam::passes
