#include "passes/raster/mask.h"

#include <tbb/parallel_for.h>

#include <utility>
#include <vector>

#include "core/tile_grid.h"

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "passes/raster/draw_items.h"

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
  SampleMask mask{.flags = common::Image<std::uint8_t>(flags.size().x, flags.size().y)};
  flags.read(mask.flags.data(), mask.flags.pixels().size());
  return mask;
}

// Bits and sums of single bytes without a branch, so that the compiler can vectorise them by 16.
struct RunOfSamples {
  unsigned surface = 0, virtual_surface = 0, specular = 0;
  std::uint8_t tile = 0;  // SampleMask::tiles

  void add(const std::uint8_t* flags, int count) {
    static_assert(SampleMask::kVirtual == 1 && SampleMask::kSpecular == 2 &&
                  SampleMask::kSurface == 4);
    unsigned char virtual_diffuse = 0, real_diffuse = 0, any = 0;
    for (int i = 0; i < count; ++i) {
      const unsigned f = flags[i];
      surface += f >> 2 & 1u;
      virtual_surface += f & 1u;
      specular += f >> 1 & 1u;
    }
    for (int i = 0; i < count; ++i) {
      const auto f = flags[i];
      const auto not_specular = static_cast<unsigned char>(~(f >> 1));
      virtual_diffuse = static_cast<unsigned char>(virtual_diffuse | (f & not_specular));
      real_diffuse = static_cast<unsigned char>(real_diffuse | (f >> 2 & ~f & not_specular));
      any = static_cast<unsigned char>(any | f);
    }
    if ((any & SampleMask::kSpecular) != 0) tile |= SampleMask::kAnySpecular;
    if ((virtual_diffuse & 1u) != 0) tile |= SampleMask::kAnyVirtualDiffuse;
    if ((real_diffuse & 1u) != 0) tile |= SampleMask::kAnyRealDiffuse;
  }
};

// Also fills mask.tiles.
SampleCounts count(SampleMask& mask, const RenderView& view) {
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  const int n = view.samples_per_side;
  mask.tiles.assign(grid.count(), 0);
  std::vector<SampleCounts> rows(static_cast<std::size_t>(grid.tiles().y));
  tbb::parallel_for(0, grid.tiles().y, [&](int row) {
    SampleCounts& counts = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < grid.tiles().x; ++column) {
      const std::size_t tile = grid.index({column, row});
      const glm::ivec2 first = grid.first_pixel(tile) * n, end = grid.end_pixel(tile) * n;
      RunOfSamples run;
      for (int y = first.y; y < end.y; ++y) run.add(&mask.flags.at(first.x, y), end.x - first.x);
      mask.tiles[tile] = run.tile;
      counts.surface += run.surface;
      counts.virtual_surface += run.virtual_surface;
      counts.specular += run.specular;
    }
  });
  SampleCounts sum;
  sum.total = mask.flags.pixels().size();
  for (const SampleCounts& counts : rows) {
    sum.surface += counts.surface;
    sum.virtual_surface += counts.virtual_surface;
    sum.specular += counts.specular;
  }
  return sum;
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
    const SampleCounts counts = count(mask, in.view);
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
