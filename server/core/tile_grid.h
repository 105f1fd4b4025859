// The tiles of a picture: the unit in which work is left out, from the first pass to the composite.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>

namespace amalgam::core {

inline constexpr int kTileSide = 16;  // pixels

// Tiles of a picture, numbered row by row from the top left. Those at the right and at the bottom
// may reach beyond it.
class TileGrid {
 public:
  TileGrid() = default;
  // size: of the picture, pixels, not negative.
  explicit TileGrid(glm::ivec2 size) : size_(size), tiles_((size + kTileSide - 1) / kTileSide) {}

  glm::ivec2 size() const { return size_; }    // pixels
  glm::ivec2 tiles() const { return tiles_; }  // across, down
  std::size_t count() const {
    return static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y);
  }

  // The tile of a pixel inside the picture.
  std::size_t tile_of(int x, int y) const { return index({x / kTileSide, y / kTileSide}); }
  std::size_t index(glm::ivec2 tile) const {
    return static_cast<std::size_t>(tile.y) * static_cast<std::size_t>(tiles_.x) +
           static_cast<std::size_t>(tile.x);
  }
  glm::ivec2 place(std::size_t tile) const {
    return {static_cast<int>(tile) % tiles_.x, static_cast<int>(tile) / tiles_.x};
  }

  // Pixels [first, end) of a tile, inside the picture.
  glm::ivec2 first_pixel(std::size_t tile) const { return place(tile) * kTileSide; }
  glm::ivec2 end_pixel(std::size_t tile) const {
    const glm::ivec2 end = first_pixel(tile) + kTileSide;
    return {std::min(end.x, size_.x), std::min(end.y, size_.y)};
  }

  bool operator==(const TileGrid&) const = default;

 private:
  glm::ivec2 size_{0};
  glm::ivec2 tiles_{0};
};

}  // namespace amalgam::core
