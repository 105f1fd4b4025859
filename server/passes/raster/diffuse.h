// The diffuse pass: shades both solutions, I_m and I_r, of every sample whose first surface is
// diffuse.
//
// For each light, with E its irradiance, c = N.L > 0 (and Ng.L > 0), and Phong's terms
// (material.h):
//   f = albedo / pi + specular (exponent + 2) / (2 pi) max(R.V, 0)^exponent        (eq. 4.6)
//   m = emission + sum E c f (mixed attenuation),  r = emission + sum E c f (real attenuation)
// Normals face the camera's side of the surface. Radiance is scene-linear.
#pragma once

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/mask.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/reached_tiles.h"
#include "passes/raster/shadow_maps.h"
#include "passes/raster/upload_view.h"

namespace amalgam::passes {

struct DiffuseInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
  MaskOutputs mask;
  ShadowMapOutputs shadows;  // absent maps: that class casts no shadows
  graph::Handle<ReachedTiles> reached;
};

// RGBA32F, one texel for each sample, 0 without a diffuse surface; undefined outside the reached
// tiles. Absent: "no diffuse object in view", or without reached tiles.
struct DiffuseOutputs {
  graph::Handle<DeviceImage> mixed;  // I_m = m; alpha: M_v, 1 on virtual surfaces
  graph::Handle<DeviceImage> real;  // I_r = r on real surfaces, 0 on virtual ones; alpha: 1 on real
};

struct ShadingInputs {
  const RasterContext& raster;
  const RenderView& view;
  graph::Handle<DeviceView> device_view;
  MaskOutputs mask;
  ShadowMapOutputs shadows;
};

// lights: by tile of the ideal image, the lights that virtual casters may occlude; null: none.
// mask_step: fragment (x, y) belongs to sample (x step + step / 2, y step + step / 2) of the mask.
struct Shading {
  const std::vector<LightSet>* lights = nullptr;
  int mask_step = 1;
  bool virtual_surfaces = true;
  bool white_surfaces = false;  // as if all were white Lambertian ones without emission
};

// Draws both solutions of the diffuse surfaces into the bound framebuffer, for a pass that has
// declared these inputs.
void draw_shaded(const ShadingInputs& in, const graph::Access& access, const Shading& shading);

DiffuseOutputs add_diffuse_pass(graph::FrameGraph& graph, const DiffuseInputs& in);

}  // namespace amalgam::passes
