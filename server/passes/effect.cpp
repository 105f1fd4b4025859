#include "passes/effect.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "gl/texture.h"
#include "passes/tile_runs.h"

namespace amalgam::passes {
namespace {

void read_tiles(const EffectInputs& in, const graph::Access& access, ShadedTiles& shaded) {
  const core::TileGrid grid({in.view.ideal.width, in.view.ideal.height});
  const gl::Texture& mixed = *access.get(in.diffuse.mixed);
  const gl::Texture& real = *access.get(in.diffuse.real);
  std::size_t samples = 0;
  shaded.runs.clear();
  for_each_run(grid, access.get(in.reached).tiles, [&](const TileRun& run) {
    const TileSamples at = samples_of(grid, run, in.view.samples_per_side);
    shaded.runs.push_back({run.first, run.count, at.first, at.size, samples});
    samples += static_cast<std::size_t>(at.size.x) * static_cast<std::size_t>(at.size.y);
  });
  shaded.mixed.resize(samples);
  shaded.real.resize(samples);
  for (const ShadedTiles::Run& run : shaded.runs) {
    const std::size_t bytes = sizeof(glm::vec4) * static_cast<std::size_t>(run.size.x) *
                              static_cast<std::size_t>(run.size.y);
    mixed.read_part(run.first, run.size, &shaded.mixed[run.offset], bytes);
    real.read_part(run.first, run.size, &shaded.real[run.offset], bytes);
  }
}

// Whether columns [x, end) of a run show anything virtual.
bool shows_virtual(const ShadedTiles& shaded, const ShadedTiles::Run& run, int x, int end) {
  for (int y = 0; y < run.size.y; ++y) {
    const std::size_t row =
        run.offset + static_cast<std::size_t>(y) * static_cast<std::size_t>(run.size.x);
    for (int i = x; i < end; ++i) {
      const glm::vec4& mixed = shaded.mixed[row + static_cast<std::size_t>(i)];
      const glm::vec4& real = shaded.real[row + static_cast<std::size_t>(i)];
      if (mixed.w != 0.0f || glm::vec3(mixed) != glm::vec3(real)) return true;
    }
  }
  return false;
}

bool find_what_shows(const RenderView& view, ShadedTiles& shaded) {
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  const int side = core::kTileSide * view.samples_per_side;
  shaded.shows.assign(grid.count(), 0);
  tbb::parallel_for(std::size_t{0}, shaded.runs.size(), [&](std::size_t r) {
    const ShadedTiles::Run& run = shaded.runs[r];
    for (std::size_t i = 0; i < run.tiles; ++i) {
      const int x = static_cast<int>(i) * side;
      shaded.shows[run.first_tile + i] =
          shows_virtual(shaded, run, x, std::min(x + side, run.size.x));
    }
  });
  return std::any_of(shaded.shows.begin(), shaded.shows.end(), [](auto shows) { return shows; });
}

}  // namespace

EffectOutputs add_effect_pass(graph::FrameGraph& graph, const EffectInputs& in) {
  graph::Builder builder = graph.add_pass("effect");
  builder.needs(in.reached);
  builder.needs(in.diffuse.mixed);
  builder.needs(in.diffuse.real);
  const EffectOutputs out{.effect = builder.writes<DiffuseEffect>("diffuse effect")};
  builder.runs([in, out](const graph::Access& access) {
    ShadedTiles& shaded = in.raster.targets.shaded;
    read_tiles(in, access, shaded);
    if (find_what_shows(in.view, shaded)) {
      access.set(out.effect, DiffuseEffect{&shaded});
    } else {
      access.leave_empty(out.effect, "nothing virtual has an effect on this frame");
    }
  });
  return out;
}

}  // namespace amalgam::passes
