// Shadow maps of all lights, apart for real and for virtual casters, so that one shading loop can
// attenuate light for the mixed and for the real image (eq. 4.6).
//
//   real attenuation  = real_opaque x real_glass
//   mixed attenuation = real attenuation x virtual_opaque x virtual_glass
//
// As a product: where nothing virtual casts a shadow the two are equal bit for bit. Mirrors are
// opaque casters. What glass lets through is defined in shaders/shadow.glsl.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "gl/buffer.h"
#include "gl/shader_interface.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/caster_cells.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/shadow_layout.h"
#include "passes/raster/upload_view.h"

namespace amalgam::passes {

using gl::CasterClass;
using gl::kCasterClasses;

// A 2D array texture, one layer for each of the layout. Opaque casters: depth 32F, reversed.
// Glass: RGBA32F at half the side, optical depth in RGB, the nearest glass's reversed depth in A.
struct ShadowMap {
  DeviceImage image = nullptr;
  std::shared_ptr<const CasterCells> cells{};  // of virtual casters only
};

// The lights and where their layers are, on both sides of the bus.
struct DeviceLights {
  ShadowLayout layout;
  gl::Buffer lights;  // shader_interface.h: GpuLight
  gl::Buffer layers;  // GpuShadowLayer
};
using SharedLights = std::shared_ptr<const DeviceLights>;

// What was drawn last, and from what. Owned by the caller, for one scene. Shadows do not depend on
// the camera: views whose markers stand still with respect to each other may share one.
struct ShadowCache {
  struct Entry {
    std::optional<gl::Texture> image;
    std::shared_ptr<const CasterCells> cells;
    SharedLights drawn_for;
  };
  std::array<Entry, kCasterClasses> entries;
  SharedLights lights;
};

struct ShadowOptions {
  int size = 0;  // texels a side; 0: by the number of layers, see make_shadow_layout()
};

struct ShadowMapInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
  ShadowCache& cache;
  ShadowOptions options{};
};

// A class without casters in this view is absent. What the cache still holds is imported, and noted
// as left out ("nothing moved since the last frame").
struct ShadowMapOutputs {
  std::array<graph::Handle<ShadowMap>, kCasterClasses> maps;  // by CasterClass
  graph::Handle<SharedLights> lights;
};

ShadowMapOutputs add_shadow_maps_pass(graph::FrameGraph& graph, const ShadowMapInputs& in);

}  // namespace amalgam::passes
