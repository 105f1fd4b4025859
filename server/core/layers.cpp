#include "core/layers.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace amalgam::core {

bool LayerTile::is_zero() const {
  return std::all_of(over.begin(), over.end(),
                     [](const glm::vec4& v) { return v == glm::vec4(0.0f); }) &&
         std::all_of(difference.begin(), difference.end(),
                     [](const glm::vec3& v) { return v == glm::vec3(0.0f); });
}

Layers::Layers(glm::ivec2 size) : grid_(size), tiles_(grid_.count()) {}

Layers::Layers(const Layers& other) : grid_(other.grid_), tiles_(other.tiles_.size()) {
  for (const std::size_t tile : other.present()) {
    tiles_[tile] = std::make_unique<LayerTile>(*other.tiles_[tile]);
  }
}

Layers& Layers::operator=(const Layers& other) {
  if (this != &other) *this = Layers(other);
  return *this;
}

LayerTile& Layers::make(std::size_t tile) {
  if (!tiles_[tile]) tiles_[tile] = std::make_unique<LayerTile>();
  return *tiles_[tile];
}

void Layers::add(Layers&& other) {
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    std::unique_ptr<LayerTile>& from = other.tiles_[i];
    std::unique_ptr<LayerTile>& to = tiles_[i];
    if (!to) {
      to = std::move(from);
    } else if (from) {
      std::transform(from->over.begin(), from->over.end(), to->over.begin(), to->over.begin(),
                     std::plus<>());
      std::transform(from->difference.begin(), from->difference.end(), to->difference.begin(),
                     to->difference.begin(), std::plus<>());
    }
  }
}

std::vector<std::size_t> Layers::present() const {
  std::vector<std::size_t> present;
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
    if (tiles_[tile]) present.push_back(tile);
  }
  return present;
}

bool Layers::is_zero() const {
  return std::all_of(tiles_.begin(), tiles_.end(),
                     [](const auto& tile) { return !tile || tile->is_zero(); });
}

glm::vec4 Layers::over(int x, int y) const {
  const LayerTile* tile = find(grid_.tile_of(x, y));
  return tile != nullptr ? tile->over[LayerTile::index(x, y)] : glm::vec4(0.0f);
}

glm::vec3 Layers::difference(int x, int y) const {
  const LayerTile* tile = find(grid_.tile_of(x, y));
  return tile != nullptr ? tile->difference[LayerTile::index(x, y)] : glm::vec3(0.0f);
}

void Layers::set(int x, int y, const glm::vec4& over, const glm::vec3& difference) {
  LayerTile& tile = make(grid_.tile_of(x, y));
  tile.over[LayerTile::index(x, y)] = over;
  tile.difference[LayerTile::index(x, y)] = difference;
}

common::ImageRgba32f Layers::over_image() const {
  common::ImageRgba32f image(size().x, size().y);
  for (int y = 0; y < size().y; ++y) {
    for (int x = 0; x < size().x; ++x) image.at(x, y) = over(x, y);
  }
  return image;
}

common::ImageRgb32f Layers::difference_image() const {
  common::ImageRgb32f image(size().x, size().y);
  for (int y = 0; y < size().y; ++y) {
    for (int x = 0; x < size().x; ++x) image.at(x, y) = difference(x, y);
  }
  return image;
}

}  // namespace amalgam::core
