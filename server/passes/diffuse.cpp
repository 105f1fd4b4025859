#include "passes/diffuse.h"

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/draw_items.h"

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

void bind_lights(const DiffuseInputs& in, const graph::Access& access) {
  const DeviceLights& lights = *access.get(in.shadows.lights);
  lights.lights.bind_uniform(gl::kLightsBinding);
  const auto count = static_cast<GLuint>(lights.layout.lights.size());
  const GLuint present = bind_shadow_maps(access, in.shadows);
  const auto tell = [&](const gl::ShaderProgram& program) {
    program.set(gl::kLightCountLocation, count);
    program.set(gl::kShadowMapsPresentLocation, present);
  };
  tell(in.raster.shaders.shade_diffuse.plain);
  if (in.raster.shaders.shade_diffuse.detailed) tell(*in.raster.shaders.shade_diffuse.detailed);
}

void draw_diffuse(const DiffuseInputs& in, const graph::Access& access, const gl::Texture& mixed,
                  const gl::Texture& real) {
  const DeviceMask& mask = access.get(in.mask.device);
  const gl::Framebuffer framebuffer({.colors = {&mixed, &real}, .depth = mask.depth});
  gl::apply({.depth = gl::PipelineState::Depth::EqualReads});
  framebuffer.bind();
  framebuffer.clear_color(0, glm::vec4(0.0f));
  framebuffer.clear_color(1, glm::vec4(0.0f));
  mask.flags->bind(gl::kMaskUnit);
  bind_lights(in, access);
  draw_items(in.raster, access.get(in.device_view), in.raster.shaders.shade_diffuse,
             TextureUse::Color,
             [](const DrawItem& item) { return !scene::is_specular(item.kind); });
  glFinish();  // or this pass's time would be charged to whoever waits for the GPU next
}

}  // namespace

DiffuseOutputs add_diffuse_pass(graph::FrameGraph& graph, const DiffuseInputs& in) {
  graph::Builder builder = graph.add_pass("diffuse");
  builder.needs(in.mask.diffuse);
  builder.needs(in.mask.device);
  builder.needs(in.device_view);
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
