// Assigns layers of the shadow maps to lights, with their matrices.
//
// A directional light has one parallel layer fitted to where shadows may begin or fall. A spot
// light has one perspective layer. A point light, or a spot wider than kMaxSpotHalfAngle, has the
// six sides of a cube. Depth is reversed: 1 at the near side and 0 at the far one; kNearPlane /
// distance in perspective layers.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/gpu_scene.h"
#include "gl/shader_interface.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

constexpr double kMaxSpotHalfAngle = 1.05;  // radians, 60 degrees

struct ShadowLayout {
  // The inputs. If these are equal, nothing moved.
  std::vector<scene::Light> lights;
  std::vector<scene::AnchoredInstance> instances;
  int requested_size = 0;

  int size = 0;  // texels a side
  std::vector<gl::GpuLight> gpu_lights;
  // By light: side of a texel, metres (perspective: at 1 m from the light).
  std::vector<float> texels;
  std::vector<gl::GpuShadowLayer> layers;
};

// Throws std::runtime_error if there are more than gl::kMaxLights lights. size: texels a side; 0:
// by the number of layers (2048 up to 8 layers, 1024 up to 32, 512 up to 128, then 256). At most
// 128 MiB for a class of casters up to 512 layers.
ShadowLayout make_shadow_layout(const RenderView& view, const gl::GpuScene& scene, int size);

// Whether the layout was made from the same lights, instances and size option.
bool is_layout_of(const ShadowLayout& layout, const RenderView& view, int size);

}  // namespace amalgam::passes
