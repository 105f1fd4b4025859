#include "passes/raster/diffuse.h"

#include <algorithm>

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/raster/draw_items.h"
#include "passes/tile_runs.h"

namespace amalgam::passes {
namespace {

// Binds the maps that are present; returns a bit for each.
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

void bind_tile_lights(const ShadingInputs& in, const Shading& shading) {
  const core::TileGrid grid({in.view.ideal.width, in.view.ideal.height});
  if (!in.raster.targets.tile_lights || in.raster.targets.tile_lights->size() != grid.tiles()) {
    in.raster.targets.tile_lights.emplace(gl::TextureFormat::R8ui, grid.tiles());
  }
  gl::Texture& texture = *in.raster.targets.tile_lights;
  if (shading.lights != nullptr) {
    texture.upload(shading.lights->data());
  } else {
    texture.upload(std::vector<LightSet>(grid.count()).data());
  }
  texture.bind(gl::kTileLightsUnit);
}

const gl::SurfaceProgram& programs_for(const RasterContext& raster,
                                       const std::vector<scene::Light>& lights, scene::Role role) {
  const bool few_suns = lights.size() <= gl::kFewSuns &&
                        std::all_of(lights.begin(), lights.end(), [](const scene::Light& light) {
                          return light.kind == scene::Light::Kind::Directional;
                        });
  if (!few_suns) return raster.shaders.shade_diffuse;
  const bool plane = role == scene::Role::Real && raster.scene.features().lone_real_plane;
  return plane ? raster.shaders.shade_lone_plane : raster.shaders.shade_under_few_suns;
}

// Prepares the targets: clears colors in the reached tiles, and sets depth elsewhere so that the
// EQUAL test fails and nothing is shaded.
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
  draw_shaded({in.raster, in.view, in.device_view, in.mask, in.shadows}, access,
              {.lights = &access.get(in.reached).lights});
  glFinish();  // or a later pass would be charged for this pass's time
}

}  // namespace

void draw_shaded(const ShadingInputs& in, const graph::Access& access, const Shading& shading) {
  const DeviceLights& lights = *access.get(in.shadows.lights);
  access.get(in.mask.device).flags->bind(gl::kMaskUnit);
  lights.lights.bind_uniform(gl::kLightsBinding);
  const auto light_count = static_cast<GLuint>(lights.layout.lights.size());
  const GLuint present = bind_shadow_maps(access, in.shadows);
  bind_tile_lights(in, shading);
  for (const scene::Role role : {scene::Role::Real, scene::Role::Virtual}) {
    if (role == scene::Role::Virtual && !shading.virtual_surfaces) continue;
    const gl::SurfaceProgram& programs = programs_for(in.raster, lights.layout.lights, role);
    const auto tell = [&](const gl::ShaderProgram& program) {
      program.set(gl::kLightCountLocation, light_count);
      program.set(gl::kShadowMapsPresentLocation, present);
      program.set(gl::kMaskStepLocation, shading.mask_step);
      program.set(gl::kWhiteSurfacesLocation, shading.white_surfaces ? 1 : 0);
      program.set(gl::kSamplesOfTileLocation, core::kTileSide * in.view.samples_per_side);
    };
    tell(programs.plain);
    if (programs.detailed) tell(*programs.detailed);
    draw_items(in.raster, access.get(in.device_view), programs, TextureUse::Color,
               [role](const DrawItem& item) {
                 return item.role == role && !scene::is_specular(item.kind);
               });
  }
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
