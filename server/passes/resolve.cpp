#include "passes/resolve.h"

#include <cmath>
#include <utility>

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/draw_items.h"
#include "passes/read_back.h"

namespace amalgam::passes {
namespace {

void draw_layers(const ResolveInputs& in, DeviceImage mixed, DeviceImage real, float exposure,
                 const gl::Texture& over, const gl::Texture& difference) {
  const gl::ShaderProgram& program = in.raster.shaders.resolve_samples;
  const gl::Framebuffer framebuffer({.colors = {&over, &difference}});
  gl::apply({});
  framebuffer.bind();
  mixed->bind(gl::kMixedUnit);
  real->bind(gl::kRealUnit);
  program.set(gl::kSamplesPerSideLocation, in.view.samples_per_side);
  program.set(gl::kExposureLocation, exposure);
  cover_screen(in.raster, program);
}

// The difference is kept as RGB; its alpha carries how many values were replaced.
std::pair<Layers, std::uint64_t> read_layers(const gl::Texture& over_texture,
                                             const gl::Texture& difference_texture) {
  const core::ImageRgba32f over = read_rgba(&over_texture);
  const core::ImageRgba32f difference = read_rgba(&difference_texture);
  Layers layers(over.size());
  double replaced = 0.0;
  for (int y = 0; y < over.height(); ++y) {
    for (int x = 0; x < over.width(); ++x) {
      const glm::vec3 color(difference.at(x, y));
      replaced += static_cast<double>(difference.at(x, y).w);
      if (over.at(x, y) == glm::vec4(0.0f) && color == glm::vec3(0.0f)) continue;
      layers.set(x, y, over.at(x, y), color);
    }
  }
  return {std::move(layers), static_cast<std::uint64_t>(std::llround(replaced))};
}

}  // namespace

ResolveOutputs add_resolve_pass(graph::FrameGraph& graph, const ResolveInputs& in) {
  graph::Builder builder = graph.add_pass("resolve");
  builder.needs(in.diffuse.mixed);
  builder.needs(in.diffuse.real);
  builder.needs(in.effect);
  builder.needs(in.exposure);
  const ResolveOutputs out{builder.writes<Layers>("diffuse layers"),
                           builder.writes<std::uint64_t>("non-finite diffuse values")};
  builder.runs([in, out](const graph::Access& access) {
    const glm::ivec2 size(in.view.ideal.width, in.view.ideal.height);
    RasterTargets& targets = in.raster.targets;
    const gl::Texture& over = ensure_target(targets.over, gl::TextureFormat::Rgba32f, size);
    const gl::Texture& difference =
        ensure_target(targets.difference, gl::TextureFormat::Rgba32f, size);
    draw_layers(in, access.get(in.diffuse.mixed), access.get(in.diffuse.real),
                access.get(in.exposure), over, difference);
    auto [layers, replaced] = read_layers(over, difference);
    access.set(out.layers, std::move(layers));
    access.set(out.nonfinite, replaced);
  });
  return out;
}

}  // namespace amalgam::passes
