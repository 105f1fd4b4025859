// The tracer's test before a shadow ray, from the coarse shadow maps of virtual casters
// (caster_cells.h).
#pragma once

#include <memory>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/shadow_maps.h"

namespace amalgam::passes {

graph::Handle<VirtualShadows> add_shadow_bound_pass(graph::FrameGraph& graph,
                                                    const ShadowMapOutputs& shadows);

}  // namespace amalgam::passes
