#include "core/layers.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

namespace amalgam::core {

LayerPixel& LayerPixel::operator+=(const LayerPixel& other) {
  over += other.over;
  difference += other.difference;
  relative_change += other.relative_change;
  return *this;
}

LayerPixel& LayerPixel::operator*=(float weight) {
  over *= weight;
  difference *= weight;
  relative_change *= weight;
  return *this;
}

glm::vec3 LayerPixel::light_ratio() const {
  if (relative_change == glm::vec3(0.0f)) return glm::vec3(1.0f);
  // Sums of samples' shares may round a little above 1.
  const float uncovered = std::max(1.0f - over.w, 1e-6f);
  return glm::max(1.0f + relative_change / uncovered, glm::vec3(0.0f));
}

bool LayerTile::is_zero() const {
  return std::all_of(pixels.begin(), pixels.end(),
                     [](const LayerPixel& pixel) { return pixel.is_zero(); });
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
      for (std::size_t pixel = 0; pixel < LayerTile::kPixels; ++pixel)
        to->pixels[pixel] += from->pixels[pixel];
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

LayerPixel Layers::at(int x, int y) const {
  const LayerTile* tile = find(grid_.tile_of(x, y));
  return tile != nullptr ? tile->at(x, y) : LayerPixel();
}

void Layers::set(int x, int y, const LayerPixel& pixel) {
  make(grid_.tile_of(x, y)).at(x, y) = pixel;
}

namespace {

template <typename Pixel, typename Value>
common::Image<Pixel> whole_image(const Layers& layers, const Value& value) {
  common::Image<Pixel> image(layers.size().x, layers.size().y);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) image.at(x, y) = value(layers.at(x, y));
  }
  return image;
}

}  // namespace

common::ImageRgba32f Layers::over_image() const {
  return whole_image<glm::vec4>(*this, [](const LayerPixel& pixel) { return pixel.over; });
}

common::ImageRgb32f Layers::difference_image() const {
  return whole_image<glm::vec3>(*this, [](const LayerPixel& pixel) { return pixel.difference; });
}

common::ImageRgb32f Layers::light_ratio_image() const {
  return whole_image<glm::vec3>(*this, [](const LayerPixel& pixel) { return pixel.light_ratio(); });
}

}  // namespace amalgam::core
