#include "passes/diffuse.h"

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/draw_items.h"

namespace amalgam::passes {
namespace {

// Binds the maps that there are and tells the shader which.
void bind_shadow_maps(const gl::ShaderProgram& program, const graph::Access& access,
                      const ShadowMapOutputs& shadows) {
  GLuint present = 0;
  for (std::size_t i = 0; i < kCasterClasses; ++i) {
    const ShadowMap* map = access.find(shadows.maps[i]);
    if (map == nullptr) continue;
    map->image->bind(gl::kShadowMapUnit + static_cast<GLuint>(i));
    present |= 1u << i;
  }
  program.set(gl::kShadowMapsPresentLocation, present);
}

void draw_diffuse(const DiffuseInputs& in, const graph::Access& access, const gl::Texture& mixed,
                  const gl::Texture& real) {
  const gl::ShaderProgram& program = in.raster.shaders.shade_diffuse;
  const DeviceMask& mask = access.get(in.mask.device);
  const gl::Framebuffer framebuffer({.colors = {&mixed, &real}, .depth = mask.depth});
  gl::apply({.depth = gl::PipelineState::Depth::EqualReads});
  framebuffer.bind();
  framebuffer.clear_color(0, glm::vec4(0.0f));
  framebuffer.clear_color(1, glm::vec4(0.0f));
  mask.flags->bind(gl::kMaskUnit);
  const DeviceLights& lights = *access.get(in.shadows.lights);
  lights.lights.bind_storage(gl::kLightsBinding);
  lights.layers.bind_storage(gl::kShadowLayersBinding);
  bind_shadow_maps(program, access, in.shadows);
  draw_items(in.raster, access.get(in.device_view), program,
             [](const DrawItem& item) { return !scene::is_specular(item.kind); });
  glFinish();  // or this pass's time would be charged to whoever waits for the GPU next
}

}  // namespace

DiffuseOutputs add_diffuse_pass(graph::FrameGraph& graph, const DiffuseInputs& in) {
  DiffuseOutputs out;
  graph
      .add_pass("diffuse",
                [&](graph::Builder& builder) {
                  builder.needs(in.mask.diffuse);
                  builder.needs(in.mask.device);
                  builder.needs(in.device_view);
                  builder.needs(in.shadows.lights);
                  for (const auto& map : in.shadows.maps) builder.uses(map);
                  out.mixed = builder.writes<DeviceImage>("I_m");
                  out.real = builder.writes<DeviceImage>("I_r");
                })
      .runs([in, out](const graph::Access& access) {
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
