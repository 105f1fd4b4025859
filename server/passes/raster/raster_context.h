// What every raster pass works with: the context, its programs, the uploaded scene, and the
// textures that live on from frame to frame.
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

// I_m and I_r of tiles, read back: runs of neighbouring tiles, each a little picture of its own.
struct ShadedTiles {
  struct Run {
    std::size_t first_tile = 0, tiles = 0;
    glm::ivec2 first{0}, size{0};  // samples
    std::size_t offset = 0;        // of its first sample in mixed and real
  };
  std::vector<Run> runs;
  std::vector<glm::vec4> mixed, real;  // as DiffuseOutputs
  std::vector<std::uint8_t> shows{};   // by tile of the ideal image: something virtual does

  std::size_t bytes() const {
    return runs.size() * sizeof(Run) + (mixed.size() + real.size()) * sizeof(glm::vec4) +
           shows.size();
  }
};

// Textures that passes draw into, and what is read back from them. Each exists from the first time
// that its pass runs and is made anew when its size changes: a scene without specular objects never
// pays for the real-only depth. All are used by one frame at a time.
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

  // In our memory.
  common::Image32f depth_here;  // the mask's
  ShadedTiles shaded;
};

// Makes the texture, or makes it anew if its size is another one, and returns it.
const gl::Texture& ensure_target(std::optional<gl::Texture>& target, gl::TextureFormat format,
                                 glm::ivec2 size);

// Size of what is rendered, in samples.
glm::ivec2 sample_size(const RenderView& view);

// References must outlive the frame graph that passes are added to. All on the context's thread.
struct RasterContext {
  const gl::EglContext& context;
  const gl::ShaderLibrary& shaders;
  const gl::GpuScene& scene;
  RasterTargets& targets;
};

}  // namespace amalgam::passes
