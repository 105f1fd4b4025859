// Warps the layers from the geometry that they were rendered in to the camera's: through the lens,
// if it distorts, and scaled up, if they were rendered at a lower resolution. The camera image is
// never resampled.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// For each pixel of the camera image, its place in the ideal image of full size.
struct WarpMap {
  // Pixel centres are integers; NaN where the lens cannot be inverted.
  common::Image<glm::vec2> at;
  // Bounds of a tile's places (core/tile_grid.h of the camera image), so that tiles with nothing to
  // show can be skipped. low > high: no place.
  struct Bounds {
    glm::vec2 low{0.0f}, high{0.0f};
  };
  std::vector<Bounds> tiles;
};

// Depends on the intrinsics alone.
WarpMap make_warp_map(const common::CameraModel& camera, const common::CameraModel& ideal);

// Border around a picture that is rendered smaller, so that its outermost pixels have neighbours to
// be interpolated with.
inline constexpr int kScaledBorder = 1;  // pixels of the smaller picture

// An undistorted camera's view in fewer pixels: scale in (0, 1] on both axes, and a border of
// kScaledBorder on all sides. A scale of 1 changes nothing.
common::CameraModel scaled_camera(const common::CameraModel& ideal, double scale);

// The placement of layers on the camera image.
struct LayerPlacement {
  glm::ivec2 size{0};             // of the camera image, pixels
  const WarpMap* lens = nullptr;  // null: the lens does not distort
  float scale = 1.0f;             // the layers are those of scaled_camera(ideal, scale)
};

// Bilinear, which is correct for premultiplied color; 0 outside the layers.
Layers warp_layers(const Layers& layers, const LayerPlacement& placement);

// Borrows the lens. Absent if the layers are empty within the camera image.
graph::Handle<Layers> add_warp_pass(graph::FrameGraph& graph, graph::Handle<Layers> layers,
                                    const LayerPlacement& placement);

}  // namespace amalgam::passes
