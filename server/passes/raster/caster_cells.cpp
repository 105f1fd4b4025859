#include "passes/raster/caster_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <utility>

namespace amalgam::passes {
namespace {

// depth(texel) of a side x side layer, cell_texels to a cell.
template <typename Depth>
void take_nearest(std::vector<float>& cells, int cell_side, int side, int cell_texels,
                  const Depth& depth) {
  for (int y = 0; y < side; ++y) {
    float* row =
        &cells[static_cast<std::size_t>(y / cell_texels) * static_cast<std::size_t>(cell_side)];
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(side);
    for (int x = 0; x < side; ++x) {
      float& cell = row[x / cell_texels];
      cell = std::max(cell, depth(first + static_cast<std::size_t>(x)));
    }
  }
}

}  // namespace

CasterCells::Level CasterCells::make_finest() const {
  const int side = static_cast<int>(std::ceil(cells_per_side_));
  return {side,
          std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side))};
}

CasterCells::Pyramid CasterCells::pyramid(Level finest) {
  Pyramid levels;
  levels.push_back(std::move(finest));
  while (levels.back().side > 1) {
    const Level& fine = levels.back();
    Level coarse{(fine.side + 1) / 2, {}};
    coarse.depths.resize(static_cast<std::size_t>(coarse.side) *
                         static_cast<std::size_t>(coarse.side));
    take_nearest(coarse.depths, coarse.side, fine.side, 2,
                 [&](std::size_t i) { return fine.depths[i]; });
    levels.push_back(std::move(coarse));
  }
  return levels;
}

CasterCells CasterCells::of(const gl::Texture& map, int map_size) {
  CasterCells cells;
  cells.cells_per_side_ = static_cast<double>(map_size) / kCellTexels;
  const int side = map.size().x;
  const auto texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  const bool glass = map.format() == gl::TextureFormat::Rgba32f;
  // For an odd opaque size, or side 1, a glass texel is not exactly two opaque texels wide.
  const bool halves = glass && side * 2 == map_size;
  const int cell_texels = halves ? kCellTexels / 2 : kCellTexels;
  if (glass && !halves) cells.cells_per_side_ = static_cast<double>(side) / kCellTexels;
  std::vector<glm::vec4> colors(glass ? texels : 0);
  std::vector<float> depths(glass ? 0 : texels);
  for (int layer = 0; layer < map.layers(); ++layer) {
    Level finest = cells.make_finest();
    if (glass) {
      map.read_part({0, 0}, map.size(), colors.data(), texels * sizeof(glm::vec4), layer);
      take_nearest(finest.depths, finest.side, side, cell_texels,
                   [&](std::size_t i) { return colors[i].w; });
    } else {
      map.read_part({0, 0}, map.size(), depths.data(), texels * sizeof(float), layer);
      take_nearest(finest.depths, finest.side, side, cell_texels,
                   [&](std::size_t i) { return depths[i]; });
    }
    cells.layers_.push_back(pyramid(std::move(finest)));
  }
  return cells;
}

CasterCells CasterCells::of_depths(const std::vector<float>& depths, int map_size) {
  CasterCells cells;
  cells.cells_per_side_ = static_cast<double>(map_size) / kCellTexels;
  Level finest = cells.make_finest();
  take_nearest(finest.depths, finest.side, map_size, kCellTexels,
               [&](std::size_t i) { return depths[i]; });
  cells.layers_.push_back(pyramid(std::move(finest)));
  return cells;
}

float CasterCells::nearest_depth(std::size_t layer, glm::dvec2 low, glm::dvec2 high) const {
  const Pyramid& levels = layers_[layer];
  if (!(low.x < 1.0) || !(low.y < 1.0) || !(high.x >= 0.0) || !(high.y >= 0.0)) return 0.0f;
  const auto cell = [&](double at) {
    return static_cast<int>(std::clamp(std::floor(at * cells_per_side_), 0.0,
                                       static_cast<double>(levels.front().side - 1)));
  };
  int x0 = cell(low.x), x1 = cell(high.x), y0 = cell(low.y), y1 = cell(high.y);
  // The finest level that needs few look-ups.
  constexpr int kMostCells = 12;
  std::size_t level = 0;
  while (std::max(x1 - x0, y1 - y0) >= kMostCells) {
    ++level;
    x0 /= 2, x1 /= 2, y0 /= 2, y1 /= 2;
  }
  float nearest = 0.0f;
  for (int y = y0; y <= y1; ++y) {
    const float* row =
        &levels[level]
             .depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(levels[level].side)];
    for (int x = x0; x <= x1; ++x) nearest = std::max(nearest, row[x]);
  }
  return nearest;
}

}  // namespace amalgam::passes
