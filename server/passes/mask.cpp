#include "passes/mask.h"

#include <utility>

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "passes/draw_items.h"

namespace amalgam::passes {
namespace {

DeviceMask draw_mask(const MaskInputs& in, const DeviceView& device_view) {
  const glm::ivec2 size = sample_size(in.view);
  RasterTargets& targets = in.raster.targets;
  const gl::Texture& flags = ensure_target(targets.mask_flags, gl::TextureFormat::R8ui, size);
  const gl::Texture& depth = ensure_target(targets.depth, gl::TextureFormat::Depth32f, size);
  const gl::Framebuffer framebuffer({.colors = {&flags}, .depth = &depth});
  gl::apply({.depth = gl::PipelineState::Depth::NearestWrites});
  framebuffer.bind();
  framebuffer.clear_color(0, glm::uvec4(0));
  framebuffer.clear_depth();
  draw_items(in.raster, device_view, in.raster.shaders.write_mask, TextureUse::Holes,
             [](const DrawItem&) { return true; });
  return {&flags, &depth};
}

SampleMask read_mask(const gl::Texture& flags) {
  SampleMask mask{core::Image<std::uint8_t>(flags.size().x, flags.size().y)};
  flags.read(mask.flags.data(), mask.flags.pixels().size());
  return mask;
}

SampleCounts count(const SampleMask& mask) {
  SampleCounts counts;
  counts.total = mask.flags.pixels().size();
  for (const std::uint8_t flags : mask.flags.pixels()) {
    counts.surface += (flags & SampleMask::kSurface) != 0 ? 1 : 0;
    counts.virtual_surface += (flags & SampleMask::kVirtual) != 0 ? 1 : 0;
    counts.specular += (flags & SampleMask::kSpecular) != 0 ? 1 : 0;
  }
  return counts;
}

}  // namespace

MaskOutputs add_mask_pass(graph::FrameGraph& graph, const MaskInputs& in) {
  graph::Builder builder = graph.add_pass("mask");
  builder.needs(in.device_view);
  const MaskOutputs out{.device = builder.writes<DeviceMask>("device mask"),
                        .mask = builder.writes<SampleMask>("M_v and M_r"),
                        .counts = builder.writes<SampleCounts>("sample counts"),
                        .specular = builder.writes<SpecularSamples>("specular samples"),
                        .diffuse = builder.writes<DiffuseSamples>("diffuse samples")};
  builder.runs([in, out](const graph::Access& access) {
    const DeviceMask device = draw_mask(in, access.get(in.device_view));
    SampleMask mask = read_mask(*device.flags);
    const SampleCounts counts = count(mask);
    access.set(out.device, device);
    access.set(out.mask, std::move(mask));
    access.set(out.counts, counts);
    if (counts.specular > 0) {
      access.set(out.specular, SpecularSamples{counts.specular});
    } else {
      access.leave_empty(out.specular, "no specular pixel in this frame");
    }
    if (counts.surface > counts.specular) {
      access.set(out.diffuse, DiffuseSamples{counts.surface - counts.specular});
    } else {
      access.leave_empty(out.diffuse, "no diffuse object in view");
    }
  });
  return out;
}

}  // namespace amalgam::passes
