#include "passes/raster/resolve.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <utility>

#include "core/tile_grid.h"
#include "scene/light/tone_map.h"

namespace amalgam::passes {
namespace {

glm::vec3 replace_nonfinite(glm::vec3 value, std::uint64_t& replaced) {
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(value[i])) continue;
    value[i] = 0.0f;
    ++replaced;
  }
  return value;
}

// One tile of a run, to be resolved to layers.
struct TileOfRun {
  const ShadedTiles& shaded;
  const ShadedTiles::Run& run;
  int left;  // samples, in the run
  glm::ivec2 pixels;
  int n;

  // Returns the number of non-finite values replaced by 0.
  std::uint64_t resolve(float exposure, core::LayerTile& layers) const {
    std::uint64_t replaced = 0;
    for (int y = 0; y < pixels.y; ++y) {
      for (int x = 0; x < pixels.x; ++x) {
        const std::size_t pixel = core::LayerTile::index(x, y);
        resolve_pixel(x, y, exposure, layers.over[pixel], layers.difference[pixel], replaced);
      }
    }
    return replaced;
  }

  void resolve_pixel(int x, int y, float exposure, glm::vec4& over, glm::vec3& difference,
                     std::uint64_t& replaced) const {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::size_t at =
            run.offset +
            static_cast<std::size_t>(y * n + j) * static_cast<std::size_t>(run.size.x) +
            static_cast<std::size_t>(left + x * n + i);
        const glm::vec4& mixed = shaded.mixed[at];
        if (mixed.w != 0.0f) {
          const glm::vec3 display = scene::tone_map(glm::vec3(mixed), exposure);
          over += glm::vec4(replace_nonfinite(display, replaced), 1.0f);
          continue;
        }
        const glm::vec4& real = shaded.real[at];
        if (glm::vec3(mixed) == glm::vec3(real)) continue;  // TM(x) - TM(x) = 0
        difference += replace_nonfinite(scene::tone_map(glm::vec3(mixed), exposure) -
                                            scene::tone_map(glm::vec3(real), exposure),
                                        replaced);
      }
    }
    const float weight = 1.0f / static_cast<float>(n * n);
    over *= weight;
    difference *= weight;
  }
};

std::pair<Layers, std::uint64_t> resolve(const RenderView& view, const ShadedTiles& shaded,
                                         float exposure) {
  Layers layers({view.ideal.width, view.ideal.height});
  const core::TileGrid& grid = layers.grid();
  std::atomic<std::uint64_t> replaced = 0;  // integers: the order of the sum does not matter
  tbb::parallel_for(std::size_t{0}, shaded.runs.size(), [&](std::size_t r) {
    const ShadedTiles::Run& run = shaded.runs[r];
    for (std::size_t i = 0; i < run.tiles; ++i) {
      const std::size_t tile = run.first_tile + i;
      if (shaded.shows[tile] == 0) continue;
      const TileOfRun samples{shaded, run,
                              static_cast<int>(i) * core::kTileSide * view.samples_per_side,
                              grid.end_pixel(tile) - grid.first_pixel(tile), view.samples_per_side};
      core::LayerTile& made = layers.make(tile);
      replaced += samples.resolve(exposure, made);
      if (made.is_zero()) layers.drop(tile);
    }
  });
  return {std::move(layers), replaced};
}

}  // namespace

ResolveOutputs add_resolve_pass(graph::FrameGraph& graph, const ResolveInputs& in) {
  graph::Builder builder = graph.add_pass("resolve");
  builder.needs(in.effect);
  builder.needs(in.exposure);
  const ResolveOutputs out{builder.writes<Layers>("diffuse layers"),
                           builder.writes<std::uint64_t>("non-finite diffuse values")};
  builder.runs([in, out](const graph::Access& access) {
    auto [layers, replaced] =
        resolve(in.view, *access.get(in.effect).tiles, access.get(in.exposure));
    access.set(out.layers, std::move(layers));
    access.set(out.nonfinite, replaced);
  });
  return out;
}

}  // namespace amalgam::passes
