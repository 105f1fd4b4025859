// Shared by all raster passes: the context, its programs, the uploaded scene, and the textures that
// are reused from frame to frame.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/egl_context.h"
#include "gl/gpu_scene.h"
#include "gl/shader_library.h"
#include "gl/texture.h"
#include "passes/frame_resources.h"

namespace amalgam::passes {

// I_m and I_r of tiles, read back in runs of neighbouring tiles. Each run is a small picture of its
// own.
struct ShadedTiles {
  struct Run {
    std::size_t first_tile = 0, tiles = 0;
    glm::ivec2 first{0}, size{0};  // samples
    std::size_t offset = 0;        // of the run's first sample in mixed and real
  };
  std::vector<Run> runs;
  std::vector<glm::vec4> mixed, real;  // as DiffuseOutputs
  std::vector<std::uint8_t> shows{};   // by tile of the ideal image: shows something virtual

  std::size_t bytes() const {
    return runs.size() * sizeof(Run) + (mixed.size() + real.size()) * sizeof(glm::vec4) +
           shows.size();
  }
};

// Textures that passes draw into, and data read back from them. Each is made when its pass first
// runs, and again when its size changes, so a scene without specular objects never pays for the
// real-only depth. Used by one frame at a time.
struct RasterTargets {
  // One texel a sample.
  std::optional<gl::Texture> mask_flags;   // R8UI, bits of SampleMask
  std::optional<gl::Texture> depth;        // 32F, reversed: near / z, 0 is infinitely far
  std::optional<gl::Texture> mixed, real;  // RGBA32F, I_m and I_r (see diffuse.h)
  std::optional<gl::Texture> tile_lights;  // R8UI, one texel a tile: LightSet (reached_tiles.h)
  // One texel an ideal pixel.
  std::optional<gl::Texture> real_depth;  // 32F, reversed
  // One texel an entry of the exposure meter's grid.
  std::optional<gl::Texture> meter, meter_unused, meter_depth;  // RGBA32F, RGBA32F, 32F

  // In main memory.
  common::Image32f depth_here;  // the mask's
  ShadedTiles shaded;
};

// Makes the texture, or remakes it if its size differs, and returns it.
const gl::Texture& ensure_target(std::optional<gl::Texture>& target, gl::TextureFormat format,
                                 glm::ivec2 size);

// Size of the rendered image, in samples.
glm::ivec2 sample_size(const RenderView& view);

// References must outlive the frame graph that passes are added to. For the context's thread only.
struct RasterContext {
  const gl::EglContext& context;
  const gl::ShaderLibrary& shaders;
  const gl::GpuScene& scene;
  RasterTargets& targets;
};

}  // namespace amalgam::passes
