// The four layers of the composite. Layers merge by adding (eq. 4.1, 4.2) and go onto the camera
// image as
//   I_f = A + (1 - a) TM(TM^-1(I_c) q) + D,   q = 1 + Q / (1 - a).
//
// Each sample is evaluated in display-linear light, and the samples of a pixel are averaged. So a
// pixel half covered by a virtual object is half object and half camera image, without a rim. Q is
// averaged over all samples, so that it adds up; q is its mean over those that are not covered.
//
// Most of a picture shows nothing virtual. Layers are therefore sparse: in tiles that do not exist
// all layers are 0.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "common/image.h"
#include "core/tile_grid.h"

namespace amalgam::core {

// One pixel of all layers.
struct LayerPixel {
  // rgb: A = mean(M_v (TM(I_m) + I_e)), premultiplied; alpha: a = mean(M_v).
  glm::vec4 over{0.0f};
  // D = mean((1 - M_v) (TM(I_m) - TM(I_r))), signed, over samples that the ratio does not serve.
  glm::vec3 difference{0.0f};
  // Q = mean((1 - M_v) (I_m / I_r - 1)) over samples of real diffuse surfaces
  // (scene/light/real_surfaces.h).
  glm::vec3 relative_change{0.0f};

  bool operator==(const LayerPixel&) const = default;
  bool is_zero() const { return *this == LayerPixel(); }
  LayerPixel& operator+=(const LayerPixel& other);
  LayerPixel& operator*=(float weight);
  // q, the factor on the light of what the pixel shows of the camera image; at least 0.
  glm::vec3 light_ratio() const;
};

// kTileSide x kTileSide pixels, row by row. Pixels beyond the picture stay 0.
struct LayerTile {
  static constexpr std::size_t kPixels = std::size_t{kTileSide} * kTileSide;
  std::array<LayerPixel, kPixels> pixels{};

  static std::size_t index(int x, int y) {  // of a pixel of the picture
    return static_cast<std::size_t>(y % kTileSide) * kTileSide +
           static_cast<std::size_t>(x % kTileSide);
  }
  LayerPixel& at(int x, int y) { return pixels[index(x, y)]; }
  const LayerPixel& at(int x, int y) const { return pixels[index(x, y)]; }
  bool is_zero() const;
};

class Layers {
 public:
  Layers() = default;
  explicit Layers(glm::ivec2 size);  // no tile exists

  Layers(const Layers& other);
  Layers& operator=(const Layers& other);
  Layers(Layers&&) noexcept = default;
  Layers& operator=(Layers&&) noexcept = default;

  const TileGrid& grid() const { return grid_; }
  glm::ivec2 size() const { return grid_.size(); }

  // Null if the tile does not exist.
  LayerTile* find(std::size_t tile) { return tiles_[tile].get(); }
  const LayerTile* find(std::size_t tile) const { return tiles_[tile].get(); }
  // The tile, made and zero-filled if it did not exist. Different tiles may be made by different
  // threads.
  LayerTile& make(std::size_t tile);
  void drop(std::size_t tile) { tiles_[tile].reset(); }
  // Adds the other layers, of the same size, taking over tiles that do not exist here.
  void add(Layers&& other);

  std::vector<std::size_t> present() const;  // tiles that exist, ascending
  bool is_zero() const;

  // Access to single pixels; slow.
  LayerPixel at(int x, int y) const;
  void set(int x, int y, const LayerPixel& pixel);

  // As whole pictures, for dumps and tests.
  common::ImageRgba32f over_image() const;
  common::ImageRgb32f difference_image() const;
  common::ImageRgb32f light_ratio_image() const;  // q

 private:
  TileGrid grid_;
  std::vector<std::unique_ptr<LayerTile>> tiles_;
};

}  // namespace amalgam::core
