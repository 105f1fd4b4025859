#include "passes/raster/raster_meter.h"

#include <glm/common.hpp>

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/raster/draw_items.h"
#include "passes/raster/read_back.h"

namespace amalgam::passes {
namespace {

// Entry (x, y) is sample (x step + step / 2, y step + step / 2). Blocks that reach beyond the image
// are left out. Entries that are not real and diffuse in the mask are 0.
common::ImageRgba32f draw_grid(const RasterMeterInputs& in, const graph::Access& access, int step,
                               bool white_surfaces) {
  const glm::ivec2 samples = sample_size(in.view);
  // A very narrow picture may be smaller than a step.
  const glm::ivec2 entries = glm::max(samples / step, 1);
  RasterTargets& targets = in.raster.targets;
  const gl::Texture& real = ensure_target(targets.meter, gl::TextureFormat::Rgba32f, entries);
  const gl::Texture& mixed =
      ensure_target(targets.meter_unused, gl::TextureFormat::Rgba32f, entries);
  const gl::Texture& depth =
      ensure_target(targets.meter_depth, gl::TextureFormat::Depth32f, entries);
  const gl::Framebuffer framebuffer({.colors = {&mixed, &real}, .depth = &depth});
  gl::apply({.depth = gl::PipelineState::Depth::NearestWrites});
  framebuffer.bind();
  framebuffer.clear_color(gl::kRealOutput, glm::vec4(0.0f));
  framebuffer.clear_depth();
  // Centres of texels fall on centres of those samples.
  const float shift = 0.5f - (static_cast<float>(step / 2) + 0.5f) / static_cast<float>(step);
  glViewportIndexedf(0, shift, shift, static_cast<float>(samples.x) / static_cast<float>(step),
                     static_cast<float>(samples.y) / static_cast<float>(step));
  draw_shaded({in.raster, in.view, in.device_view, in.mask, in.shadows}, access,
              {.mask_step = step, .virtual_surfaces = false, .white_surfaces = white_surfaces});
  return read_rgba(&real);
}

}  // namespace

graph::Handle<MeterGrid> add_raster_meter_pass(graph::FrameGraph& graph,
                                               const RasterMeterInputs& in) {
  graph::Builder builder = graph.add_pass("meter");
  builder.needs(in.mask.diffuse);
  builder.needs(in.mask.device);
  builder.needs(in.device_view);
  builder.needs(in.shadows.lights);
  for (const auto& map : in.shadows.maps) builder.uses(map);
  const auto out = builder.writes<MeterGrid>("meter grid");
  builder.runs([in, out](const graph::Access& access) {
    const int step = meter_step(sample_size(in.view));
    access.set(out, MeterGrid{draw_grid(in, access, step, false), draw_grid(in, access, step, true),
                              step, in.view.samples_per_side});
  });
  return out;
}

}  // namespace amalgam::passes
