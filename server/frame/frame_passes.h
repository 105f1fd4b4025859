// Connects the passes of one frame, for each renderer mode.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "frame/frame.h"
#include "frame/renderer_settings.h"
#include "frame/view_state.h"
#include "graph/frame_graph.h"
#include "passes/image/composite.h"
#include "passes/image/decode.h"
#include "passes/image/encode.h"
#include "passes/image/refine.h"
#include "passes/image/trace.h"
#include "passes/raster/diffuse.h"
#include "passes/raster/effect.h"
#include "passes/raster/mask.h"
#include "passes/raster/shadow_maps.h"
#include "scene/bounds.h"
#include "scene/features.h"

namespace amalgam::frame {

// Resources that outlive a frame and are shared by all views of a scene.
struct SceneResources {
  const scene::Scene& scene;
  const scene::SceneFeatures& features;
  std::span<const scene::Bounds> mesh_bounds;
  const Surroundings& surroundings;               // of the view
  trace::EmbreeScene* embree = nullptr;           // null: nothing of the scene is ever traced
  const passes::RasterContext* raster = nullptr;  // null: nothing is rasterised
  passes::ShadowCache* shadows = nullptr;         // goes with raster
};

struct FrameRequest {
  const RendererSettings& settings;
  const FrameInput& input;
  ViewState& view;
  const passes::RenderView& render_view;
  bool keep_buffers = false;
  const StillFrame* still = nullptr;  // the results of an equal frame; null: all are made anew
  bool keep_still = false;            // keep results for the next equal frame
};

// Handles to everything that may be requested of a frame. All are set; a resource that the mode
// lacks is absent.
struct FramePasses {
  std::optional<std::string> nothing;  // why nothing virtual can show, if known in advance
  graph::Handle<passes::CameraImage> camera_image;
  graph::Handle<passes::MeterGrid> meter_grid;
  graph::Handle<scene::ToneMap> tone_map;
  graph::Handle<passes::PlacedScene> placed;
  passes::MaskOutputs mask;
  passes::DiffuseOutputs diffuse;
  graph::Handle<passes::DiffuseEffect> effect;
  graph::Handle<passes::RealDepth> real_depth;
  graph::Handle<passes::VirtualShadows> virtual_shadows;
  graph::Handle<passes::Layers> rasterised;
  graph::Handle<std::uint64_t> rasterised_nonfinite;
  graph::Handle<trace::TraceResult> traced;
  graph::Handle<passes::Refinement> refinement;
  graph::Handle<passes::Layers> layers;  // merged and refined, ideal geometry
  graph::Handle<passes::Composite> composite;
  graph::Handle<passes::EncodedImage> encoded;
};

FramePasses add_frame_passes(graph::FrameGraph& graph, const SceneResources& resources,
                             const FrameRequest& request);

}  // namespace amalgam::frame
