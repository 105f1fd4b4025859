#include "passes/diffuse.h"

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/draw_items.h"
#include "passes/tile_runs.h"

namespace amalgam::passes {
namespace {

// Binds the maps that there are; returns a bit for each.
GLuint bind_shadow_maps(const graph::Access& access, const ShadowMapOutputs& shadows) {
  GLuint present = 0;
  for (std::size_t i = 0; i < kCasterClasses; ++i) {
    const ShadowMap* map = access.find(shadows.maps[i]);
    if (map == nullptr) continue;
    map->image->bind(gl::kShadowMapUnit + static_cast<GLuint>(i));
    present |= 1u << i;
  }
  return present;
}

// Makes ready what is drawn into: colours are cleared in the reached tiles, and depth is put out of
// reach of the EQUAL test in the others, so that nothing is shaded there.
void keep_reached(const RenderView& view, const ReachedTiles& reached, const gl::Texture& mixed,
                  const gl::Texture& real, const gl::Texture& depth) {
  constexpr float kNowhere = 1.0f;  // the near plane
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  for_each_run(grid, reached.tiles, [&](const TileRun& run) {
    const TileSamples at = samples_of(grid, run, view.samples_per_side);
    mixed.clear_part(at.first, at.size, 0.0f);
    real.clear_part(at.first, at.size, 0.0f);
  });
  for_each_run(grid, others(grid, reached.tiles), [&](const TileRun& run) {
    const TileSamples at = samples_of(grid, run, view.samples_per_side);
    depth.clear_part(at.first, at.size, kNowhere);
  });
}

void draw_diffuse(const DiffuseInputs& in, const graph::Access& access, const gl::Texture& mixed,
                  const gl::Texture& real) {
  const DeviceMask& mask = access.get(in.mask.device);
  keep_reached(in.view, access.get(in.reached), mixed, real, *mask.depth);
  const gl::Framebuffer framebuffer({.colors = {&mixed, &real}, .depth = mask.depth});
  gl::apply({.depth = gl::PipelineState::Depth::EqualReads});
  framebuffer.bind();
  tell_mask_step(in.raster, 1);
  mask.flags->bind(gl::kMaskUnit);
  bind_lights(in.raster, in.shadows, access);
  draw_items(in.raster, access.get(in.device_view), in.raster.shaders.shade_diffuse,
             TextureUse::Color,
             [](const DrawItem& item) { return !scene::is_specular(item.kind); });
  glFinish();  // or this pass's time would be charged to whoever waits for the GPU next
}

}  // namespace

void tell_mask_step(const RasterContext& raster, int step) {
  raster.shaders.shade_diffuse.plain.set(gl::kMaskStepLocation, step);
  if (raster.shaders.shade_diffuse.detailed) {
    raster.shaders.shade_diffuse.detailed->set(gl::kMaskStepLocation, step);
  }
}

void bind_lights(const RasterContext& raster, const ShadowMapOutputs& shadows,
                 const graph::Access& access) {
  const DeviceLights& lights = *access.get(shadows.lights);
  lights.lights.bind_uniform(gl::kLightsBinding);
  const auto count = static_cast<GLuint>(lights.layout.lights.size());
  const GLuint present = bind_shadow_maps(access, shadows);
  const auto tell = [&](const gl::ShaderProgram& program) {
    program.set(gl::kLightCountLocation, count);
    program.set(gl::kShadowMapsPresentLocation, present);
  };
  tell(raster.shaders.shade_diffuse.plain);
  if (raster.shaders.shade_diffuse.detailed) tell(*raster.shaders.shade_diffuse.detailed);
}

DiffuseOutputs add_diffuse_pass(graph::FrameGraph& graph, const DiffuseInputs& in) {
  graph::Builder builder = graph.add_pass("diffuse");
  builder.needs(in.mask.diffuse);
  builder.needs(in.mask.device);
  builder.needs(in.device_view);
  builder.needs(in.reached);
  builder.needs(in.shadows.lights);
  for (const auto& map : in.shadows.maps) builder.uses(map);
  const DiffuseOutputs out{.mixed = builder.writes<DeviceImage>("I_m"),
                           .real = builder.writes<DeviceImage>("I_r")};
  builder.runs([in, out](const graph::Access& access) {
    const glm::ivec2 size = sample_size(in.view);
    RasterTargets& targets = in.raster.targets;
    const gl::Texture& mixed = ensure_target(targets.mixed, gl::TextureFormat::Rgba32f, size);
    const gl::Texture& real = ensure_target(targets.real, gl::TextureFormat::Rgba32f, size);
    draw_diffuse(in, access, mixed, real);
    access.set(out.mixed, DeviceImage(&mixed));
    access.set(out.real, DeviceImage(&real));
  });
  return out;
}

}  // namespace amalgam::passes
