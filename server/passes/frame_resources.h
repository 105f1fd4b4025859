// The resources that flow between passes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "core/layers.h"
#include "core/progress.h"
#include "gl/shader_interface.h"
#include "scene/anchored_scene.h"
#include "scene/light/light.h"
#include "trace/shadow_bound.h"

namespace amalgam::gl {
class Texture;
}

namespace amalgam::passes {

// The reason of a pass that is left out because its results from an earlier frame still hold.
inline constexpr const char* kNothingMoved = "nothing moved since the last frame";

// One frame's geometry, ready to be drawn or traced.
struct RenderView {
  common::CameraModel camera;  // the client's, with distortion
  // The camera that is rendered with: pinhole, with a margin; equals camera without distortion.
  common::CameraModel ideal;
  scene::AnchoredScene scene;        // world-frame transforms and the camera
  std::vector<scene::Light> lights;  // environment and punctual lights, world frame
  int samples_per_side = 1;          // n: n x n samples a pixel on a regular grid, 1..4
  core::Progress* progress = nullptr;
};

// A texture on the GPU, owned elsewhere and valid until the end of the frame.
using DeviceImage = const gl::Texture*;

// M_v and M_r, one value for each *sample*: size ideal.size * samples_per_side, row 0 at the top.
struct SampleMask {
  // M_v: the nearest surface is virtual
  static constexpr std::uint8_t kVirtual = gl::kVirtualFlag;
  // M_r: the nearest surface is specular
  static constexpr std::uint8_t kSpecular = gl::kSpecularFlag;
  static constexpr std::uint8_t kSurface = gl::kSurfaceFlag;  // there is a surface
  common::Image<std::uint8_t> flags;

  // The kinds of surfaces in each tile of the ideal image, so that no pass has to go over all
  // samples again.
  static constexpr std::uint8_t kAnySpecular = 1;
  static constexpr std::uint8_t kAnyVirtualDiffuse = 2;
  static constexpr std::uint8_t kAnyRealDiffuse = 4;
  std::vector<std::uint8_t> tiles{};  // by core::TileGrid(ideal size)
};

// Camera-frame z (metres, positive) of the nearest *real* surface at each ideal pixel's centre;
// infinity where there is none.
struct RealDepth {
  common::Image32f z;
};

// Absent if there is no such sample. Passes that work on them need it.
struct SpecularSamples {
  std::uint64_t count = 0;
};
struct DiffuseSamples {
  std::uint64_t count = 0;
};

// Tested by the tracer before it casts a shadow ray.
using VirtualShadows = std::shared_ptr<const trace::ShadowBound>;

// Layers in the ideal camera's geometry, one value for each pixel.
using Layers = core::Layers;

}  // namespace amalgam::passes
