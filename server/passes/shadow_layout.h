// Which light is seen through which layers of the shadow maps, and by which matrices.
//
// A directional light has one parallel layer fitted to everything in the scene, a spot light one
// perspective layer, a point light (and a spot wider than kMaxSpotHalfAngle) the six sides of a
// cube. Depth is reversed in all: 1 at the near side, 0 at the far one.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "gl/gpu_scene.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

constexpr double kMaxSpotHalfAngle = 1.05;  // radians, 60 degrees

struct ShadowLayer {
  glm::mat4 clip_from_world{1.0f};
  std::uint32_t light = 0;  // index into RenderView::lights
  // Side of a texel: metres for parallel layers; for perspective ones metres at 1 m from the light.
  float texel = 0.0f;
  bool perspective = false;
  glm::vec3 eye{0.0f};  // perspective: the light's position; parallel: unit vector to the light
};

struct ShadowLayout {
  // What it was made from: if these are equal, nothing moved.
  std::vector<scene::Light> lights;
  std::vector<scene::AnchoredInstance> instances;

  int size = 0;  // texels a side
  std::vector<ShadowLayer> layers;
  std::vector<std::uint32_t> first_layer;  // of each light
};

// Throws std::runtime_error if the lights need more layers than the context's textures may have.
ShadowLayout make_shadow_layout(const RenderView& view, const gl::GpuScene& scene, int size);

// The layout was made from the same lights and instances, and with the same size option.
bool is_layout_of(const ShadowLayout& layout, const RenderView& view);

}  // namespace amalgam::passes
