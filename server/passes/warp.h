// From the ideal pinhole geometry of rendering to the camera's own, distorted one. The camera image
// is never resampled; the layers are.
#pragma once

#include <glm/vec2.hpp>

#include "core/camera_model.h"
#include "core/image.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// For each pixel of the camera, where it lies in the ideal image (pixel centres are integers); NaN
// where the lens cannot be inverted. Depends on the intrinsics alone.
core::Image<glm::vec2> make_warp_map(const core::CameraModel& camera,
                                     const core::CameraModel& ideal);

// Bilinear; outside the ideal image there is nothing.
Layers warp_layers(const Layers& ideal_layers, const core::Image<glm::vec2>& map);

// Borrows the map.
graph::Handle<Layers> add_warp_pass(graph::FrameGraph& graph, graph::Handle<Layers> ideal_layers,
                                    const core::Image<glm::vec2>& map);

}  // namespace amalgam::passes
