// Composites virtual onto real: I_f = A + (1 - a) TM(TM^-1(I_c) q) + D (eq. 4.5 in layers,
// core/layers.h), in display-linear light.
#pragma once

#include <cstdint>
#include <vector>

#include "common/image.h"
#include "core/layers.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/decode.h"
#include "scene/light/tone_map.h"

namespace amalgam::passes {

// The composite, sRGB-encoded. Where all layers are 0 the camera's bytes are unchanged. Layers and
// image must have the same size.
common::ImageRgb8 composite(const core::Layers& layers, common::ImageRgb8 camera_image,
                            scene::ToneCurve curve = scene::ToneCurve::Reinhard);

struct Composite {
  common::ImageRgb8 pixels;
  std::vector<std::uint8_t> changed;  // by tile (core/tile_grid.h): 0 if all bytes are the camera's
};

struct CompositeInputs {
  graph::Handle<Layers> layers;  // in the camera's geometry
  graph::Handle<CameraImage> camera_image;
  graph::Handle<scene::ToneMap> tone_map;
  // Without layers the composite is the camera image, for a client that wants another quality.
  bool even_if_unchanged = false;
};

graph::Handle<Composite> add_composite_pass(graph::FrameGraph& graph, const CompositeInputs& in);

}  // namespace amalgam::passes
