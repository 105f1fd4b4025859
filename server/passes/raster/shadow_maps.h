// Shadow maps of all lights, separate for real and virtual casters, so that one shading loop can
// attenuate light for the mixed and for the real image (eq. 4.6).
//
//   real attenuation  = real_opaque x real_glass
//   mixed attenuation = real attenuation x virtual_opaque x virtual_glass
//
// Because of the product, the two are equal bit for bit where nothing virtual casts a shadow.
// Mirrors are opaque casters. The transmittance of glass is defined in shaders/shadow.glsl.
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

// A 2D array texture with the layout's layers. Opaque casters: depth 32F, reversed. Glass: RGBA32F
// at half the side, optical depth in RGB, the reversed depth of the nearest glass in A.
struct ShadowMap {
  DeviceImage image = nullptr;
  std::shared_ptr<const CasterCells> cells{};  // of virtual casters only
};

// The lights and their layers, on the CPU and on the GPU.
struct DeviceLights {
  ShadowLayout layout;
  gl::Buffer lights;  // shader_interface.h: GpuLight
  gl::Buffer layers;  // GpuShadowLayer
};
using SharedLights = std::shared_ptr<const DeviceLights>;

// The maps drawn last, and the lights they were drawn for. Owned by the caller, one for each scene.
// Shadows do not depend on the camera, so views may share a cache as long as their markers do not
// move relative to each other.
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

// A class without casters in this view is absent. Maps in the cache are imported, and the pass is
// noted as left out (kNothingMoved).
struct ShadowMapOutputs {
  std::array<graph::Handle<ShadowMap>, kCasterClasses> maps;  // by CasterClass
  graph::Handle<SharedLights> lights;
};

ShadowMapOutputs add_shadow_maps_pass(graph::FrameGraph& graph, const ShadowMapInputs& in);

}  // namespace amalgam::passes
