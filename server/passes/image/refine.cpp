#include "passes/image/refine.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace amalgam::passes {
namespace {

bool shows_something(const core::Layers& layers, glm::ivec2 p) {
  return !layers.at(p.x, p.y).is_zero();
}

// At least the step in the composite: a change of q changes a display-linear color by at most as
// much.
float layer_step(const core::Layers& layers, glm::ivec2 p, glm::ivec2 q) {
  const core::LayerPixel a = layers.at(p.x, p.y), b = layers.at(q.x, q.y);
  const glm::vec4 over = glm::abs(a.over - b.over);
  const glm::vec3 real = glm::max(glm::abs(a.difference - b.difference),
                                  glm::abs(a.relative_change - b.relative_change));
  return std::max({over.x, over.y, over.z, over.w, real.x, real.y, real.z});
}

bool is_other_surface(const trace::FirstHits& hits, glm::ivec2 p, glm::ivec2 q) {
  if (hits.instance.at(p.x, p.y) != hits.instance.at(q.x, q.y)) return true;
  // The distance of one slanted surface changes by less from pixel to pixel.
  constexpr float kStep = 1.02f;
  const auto [near, far] = std::minmax(hits.distance.at(p.x, p.y), hits.distance.at(q.x, q.y));
  return std::isfinite(far) && far > kStep * near;
}

// All n x n samples of the marked pixels.
common::Image<std::uint8_t> sample_mask(const common::Image<std::uint8_t>& pixels, int n) {
  common::Image<std::uint8_t> mask(pixels.width() * n, pixels.height() * n);
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) mask.at(x, y) = pixels.at(x / n, y / n);
  }
  return mask;
}

void replace_marked(core::Layers& layers, const core::Layers& refined,
                    const common::Image<std::uint8_t>& marked) {
  for (int y = 0; y < marked.height(); ++y) {
    for (int x = 0; x < marked.width(); ++x) {
      if (marked.at(x, y) == 0) continue;
      layers.set(x, y, refined.at(x, y));
    }
  }
}

std::uint64_t pixels_of(const core::TileGrid& grid, const std::vector<std::size_t>& tiles) {
  std::uint64_t count = 0;
  for (const std::size_t tile : tiles) {
    const glm::ivec2 size = grid.end_pixel(tile) - grid.first_pixel(tile);
    count += static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  }
  return count;
}

}  // namespace

std::vector<std::size_t> tiles_with_neighbours(const core::Layers& layers) {
  const core::TileGrid& grid = layers.grid();
  std::vector<std::uint8_t> wanted(grid.count());
  for (const std::size_t tile : layers.present()) {
    const glm::ivec2 at = grid.place(tile);
    for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, grid.tiles().y - 1); ++y) {
      for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, grid.tiles().x - 1); ++x)
        wanted[grid.index({x, y})] = 1;
    }
  }
  std::vector<std::size_t> tiles;
  for (std::size_t tile = 0; tile < wanted.size(); ++tile) {
    if (wanted[tile] != 0) tiles.push_back(tile);
  }
  return tiles;
}

common::Image<std::uint8_t> find_edges(const core::Layers& layers, const trace::FirstHits* hits,
                                       float threshold) {
  common::Image<std::uint8_t> edges(layers.size().x, layers.size().y);
  const auto compare = [&](glm::ivec2 p, glm::ivec2 q) {
    const bool differs =
        layer_step(layers, p, q) > threshold || (hits != nullptr && is_other_surface(*hits, p, q));
    if (!differs || !(shows_something(layers, p) || shows_something(layers, q))) return;
    edges.at(p.x, p.y) = 1;
    edges.at(q.x, q.y) = 1;
  };
  const core::TileGrid& grid = layers.grid();
  for (const std::size_t tile : tiles_with_neighbours(layers)) {
    const glm::ivec2 first = grid.first_pixel(tile), end = grid.end_pixel(tile);
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        if (x + 1 < edges.width()) compare({x, y}, {x + 1, y});
        if (y + 1 < edges.height()) compare({x, y}, {x, y + 1});
      }
    }
  }
  return edges;
}

RefineOutputs add_refine_pass(graph::FrameGraph& graph, const RefineInputs& in) {
  graph::Builder builder = graph.add_pass("refine");
  builder.needs(in.base);
  declare_trace_reads(builder, in.trace);
  const RefineOutputs out{builder.writes<Layers>("refined layers"),
                          builder.writes<Refinement>("refinement")};
  builder.runs([in, out](const graph::Access& access) {
    const RenderView& view = in.trace.view;
    Layers layers = access.get(in.base);
    std::optional<trace::FirstHits> hits;
    std::uint64_t asked = 0;
    if (in.by_surface) {
      const std::vector<std::size_t> tiles = tiles_with_neighbours(layers);
      hits = trace::find_first_hits(*access.get(in.trace.scene).scene, view.ideal,
                                    view.scene.camera_from_world, tiles);
      asked = pixels_of(layers.grid(), tiles);
    }
    common::Image<std::uint8_t> edges = find_edges(layers, hits ? &*hits : nullptr, in.threshold);
    const common::Image<std::uint8_t> mask = sample_mask(edges, in.samples_per_side);
    trace::TraceResult refined = trace_samples(in.trace, access, {&mask, 1, in.samples_per_side});
    replace_marked(layers, refined.layers, edges);

    Refinement statistics{.rays = refined.counts.rays,
                          .nonfinite = refined.nonfinite,
                          .truncation = refined.truncation};
    statistics.rays.primary += asked;
    statistics.pixels =
        static_cast<std::uint64_t>(std::count(edges.pixels().begin(), edges.pixels().end(), 1));
    statistics.marked = std::move(edges);
    statistics.provenance = std::move(refined.provenance);
    access.set(out.layers, std::move(layers));
    access.set(out.statistics, std::move(statistics));
  });
  return out;
}

}  // namespace amalgam::passes
