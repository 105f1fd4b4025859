#include "passes/raster/effect.h"

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

std::size_t samples_in(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

ShadedTiles copy_what_shows(const ShadedTiles& shaded, const RenderView& view) {
  const core::TileGrid grid({view.ideal.width, view.ideal.height});
  ShadedTiles copy;
  copy.shows = shaded.shows;
  for (const ShadedTiles::Run& run : shaded.runs) {
    for (std::size_t i = 0; i < run.tiles; ++i) {
      const std::size_t tile = run.first_tile + i;
      if (shaded.shows[tile] == 0) continue;
      const TileSamples at = samples_of(grid, {tile, 1}, view.samples_per_side);
      copy.runs.push_back({tile, 1, at.first, at.size, copy.mixed.size()});
      for (int y = 0; y < at.size.y; ++y) {
        const std::size_t row = run.offset + samples_in({run.size.x, y}) +
                                static_cast<std::size_t>(at.first.x - run.first.x);
        const auto copy_row = [&](const std::vector<glm::vec4>& from, std::vector<glm::vec4>& to) {
          to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(row),
                    from.begin() + static_cast<std::ptrdiff_t>(row) + at.size.x);
        };
        copy_row(shaded.mixed, copy.mixed);
        copy_row(shaded.real, copy.real);
      }
    }
  }
  return copy;
}

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
