// All raster passes wired up as the renderer wires them, for one scene, so that a test says only
// what it looks at.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/egl_context.h"
#include "graph/frame_graph.h"
#include "passes/raster/diffuse.h"
#include "passes/raster/effect.h"
#include "passes/raster/mask.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/read_back.h"
#include "passes/raster/real_depth.h"
#include "passes/raster/resolve.h"
#include "passes/raster/shadow_maps.h"
#include "passes/raster/upload_view.h"

namespace amalgam::test_support {

// What one frame gave; nothing where the graph left it out.
struct RasterFrame {
  std::optional<passes::SampleMask> mask;
  std::optional<passes::SampleCounts> counts;
  std::optional<passes::RealDepth> real_depth;
  std::optional<common::ImageRgba32f> mixed, real;  // I_m, I_r
  std::vector<std::size_t> reached;
  std::optional<passes::Layers> layers;
  std::uint64_t nonfinite = 0;
  bool diffuse_effect = false;
  std::vector<graph::PassReport> reports;

  // The report of a pass; aborts the test program if there is none.
  const graph::PassReport& report(const std::string& pass) const;
};

// One for the whole test program: a second one would take the thread from it.
std::shared_ptr<gl::EglContext> shared_context();

class RasterRig {
 public:
  explicit RasterRig(const scene::Scene& scene);

  // Realises everything that there is.
  RasterFrame render(const passes::RenderView& view, float exposure = 1.0f,
                     scene::RealSurfaces real_surfaces = scene::RealSurfaces::Difference);

  passes::ShadowOptions shadow_options{};
  bool leave_out_tiles = false;  // if so, there is no mixed and no real

 private:
  std::shared_ptr<gl::EglContext> context_;
  gl::GpuScene scene_;
  gl::ShaderLibrary shaders_;
  passes::RasterTargets targets_;
  passes::ShadowCache shadows_;
};

}  // namespace amalgam::test_support
