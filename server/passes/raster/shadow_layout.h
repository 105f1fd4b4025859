// Which light is seen through which layers of the shadow maps, and by which matrices.
//
// A directional light has one parallel layer fitted to everything in the scene, a spot light one
// perspective layer, a point light (and a spot wider than kMaxSpotHalfAngle) the six sides of a
// cube. Depth is reversed in all: 1 (or kNearPlane / distance) at the near side, 0 at the far one.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/gpu_scene.h"
#include "gl/shader_interface.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

constexpr double kMaxSpotHalfAngle = 1.05;  // radians, 60 degrees

struct ShadowLayout {
  // What it was made from: if these are equal, nothing moved.
  std::vector<scene::Light> lights;
  std::vector<scene::AnchoredInstance> instances;
  int requested_size = 0;

  int size = 0;  // texels a side
  std::vector<gl::GpuLight> gpu_lights;
  std::vector<gl::GpuShadowLayer> layers;
};

// Throws std::runtime_error if there are more than gl::kMaxLights lights.
// size: texels a side; 0: by the number of layers (2048 to 8, 1024 to 32, 512 to 128, then
// 256: 128 MiB a class of casters, or less).
ShadowLayout make_shadow_layout(const RenderView& view, const gl::GpuScene& scene, int size);

// The layout was made from the same lights and instances, and with the same size option.
bool is_layout_of(const ShadowLayout& layout, const RenderView& view, int size);

}  // namespace amalgam::passes
