// Groups listed tiles to runs of neighbours in a row, for calls whose cost is per rectangle.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/tile_grid.h"

namespace amalgam::passes {

struct TileRun {
  std::size_t first = 0, count = 0;  // tiles
};

struct TileSamples {
  glm::ivec2 first{0}, size{0};  // samples
};

// n: samples a pixel's side.
inline TileSamples samples_of(const core::TileGrid& grid, const TileRun& run, int n) {
  const glm::ivec2 first = grid.first_pixel(run.first) * n;
  return {first, grid.end_pixel(run.first + run.count - 1) * n - first};
}

// Calls visit(TileRun) for each run. tiles: ascending.
template <typename Visit>
void for_each_run(const core::TileGrid& grid, const std::vector<std::size_t>& tiles,
                  const Visit& visit) {
  for (std::size_t i = 0; i < tiles.size();) {
    TileRun run{tiles[i], 1};
    while (i + run.count < tiles.size() && tiles[i + run.count] == run.first + run.count &&
           grid.place(tiles[i + run.count]).y == grid.place(run.first).y) {
      ++run.count;
    }
    visit(run);
    i += run.count;
  }
}

// The tiles that are not in the ascending list.
inline std::vector<std::size_t> others(const core::TileGrid& grid,
                                       const std::vector<std::size_t>& tiles) {
  std::vector<std::size_t> rest;
  auto next = tiles.begin();
  for (std::size_t tile = 0; tile < grid.count(); ++tile) {
    if (next != tiles.end() && *next == tile) {
      ++next;
    } else {
      rest.push_back(tile);
    }
  }
  return rest;
}

}  // namespace amalgam::passes
