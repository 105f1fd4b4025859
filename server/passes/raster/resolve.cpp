#include "passes/raster/resolve.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <utility>

#include "core/tile_grid.h"
#include "scene/light/real_surfaces.h"

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

  const scene::ToneMap& tone_map;
  scene::RealSurfaces real_surfaces;

  // Returns the number of non-finite values replaced by 0.
  std::uint64_t resolve(core::LayerTile& layers) const {
    std::uint64_t replaced = 0;
    for (int y = 0; y < pixels.y; ++y) {
      for (int x = 0; x < pixels.x; ++x) layers.at(x, y) = resolve_pixel(x, y, replaced);
    }
    return replaced;
  }

  core::LayerPixel resolve_pixel(int x, int y, std::uint64_t& replaced) const {
    core::LayerPixel sum;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::size_t at =
            run.offset +
            static_cast<std::size_t>(y * n + j) * static_cast<std::size_t>(run.size.x) +
            static_cast<std::size_t>(left + x * n + i);
        sum += resolve_sample(shaded.mixed[at], shaded.real[at], replaced);
      }
    }
    sum *= 1.0f / static_cast<float>(n * n);
    return sum;
  }

  core::LayerPixel resolve_sample(const glm::vec4& mixed, const glm::vec4& real,
                                  std::uint64_t& replaced) const {
    if (mixed.w != 0.0f) {
      const glm::vec3 display = scene::tone_map(glm::vec3(mixed), tone_map);
      return {.over = glm::vec4(replace_nonfinite(display, replaced), 1.0f)};
    }
    const scene::LightChange change =
        scene::light_change(glm::vec3(mixed), glm::vec3(real), tone_map, real_surfaces);
    return {.difference = replace_nonfinite(change.difference, replaced),
            .relative_change = replace_nonfinite(change.relative, replaced)};
  }
};

std::pair<Layers, std::uint64_t> resolve(const ResolveInputs& in, const ShadedTiles& shaded,
                                         const scene::ToneMap& tone_map) {
  const RenderView& view = in.view;
  Layers layers({view.ideal.width, view.ideal.height});
  const core::TileGrid& grid = layers.grid();
  std::atomic<std::uint64_t> replaced = 0;  // integers: the order of the sum does not matter
  tbb::parallel_for(std::size_t{0}, shaded.runs.size(), [&](std::size_t r) {
    const ShadedTiles::Run& run = shaded.runs[r];
    for (std::size_t i = 0; i < run.tiles; ++i) {
      const std::size_t tile = run.first_tile + i;
      if (shaded.shows[tile] == 0) continue;
      const TileOfRun samples{shaded,
                              run,
                              static_cast<int>(i) * core::kTileSide * view.samples_per_side,
                              grid.end_pixel(tile) - grid.first_pixel(tile),
                              view.samples_per_side,
                              tone_map,
                              in.real_surfaces};
      core::LayerTile& made = layers.make(tile);
      replaced += samples.resolve(made);
      if (made.is_zero()) layers.drop(tile);
    }
  });
  return {std::move(layers), replaced};
}

}  // namespace

ResolveOutputs add_resolve_pass(graph::FrameGraph& graph, const ResolveInputs& in) {
  graph::Builder builder = graph.add_pass("resolve");
  builder.needs(in.effect);
  builder.needs(in.tone_map);
  const ResolveOutputs out{builder.writes<Layers>("diffuse layers"),
                           builder.writes<std::uint64_t>("non-finite diffuse values")};
  builder.runs([in, out](const graph::Access& access) {
    auto [layers, replaced] = resolve(in, *access.get(in.effect).tiles, access.get(in.tone_map));
    access.set(out.layers, std::move(layers));
    access.set(out.nonfinite, replaced);
  });
  return out;
}

}  // namespace amalgam::passes
