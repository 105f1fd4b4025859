// A coarse version of a shadow map, made when the map is drawn. For each cell of kCellTexels x
// kCellTexels texels of a layer it holds the depth of the caster nearest to the light. A point that
// is nearer to the light than the casters of all cells around it is not in shadow.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "gl/texture.h"

namespace amalgam::passes {

class CasterCells {
 public:
  static constexpr int kCellTexels = 8;  // of an opaque map; glass maps have half the side

  // Of a ShadowMap of opaque casters (depth) or of glass (depth in alpha). map_size: texels a side
  // of the opaque maps. Reads the map back.
  static CasterCells of(const gl::Texture& map, int map_size);

  // For tests: one layer from the depths of map_size x map_size texels.
  static CasterCells of_depths(const std::vector<float>& depths, int map_size);

  // The greatest reversed depth of a layer's casters in the rectangle [low, high]; 0 without
  // casters. low, high: in units of the map's side, [0, 1] inside. Never less than the depth that a
  // look-up in the rectangle finds.
  float nearest_depth(std::size_t layer, glm::dvec2 low, glm::dvec2 high) const;
  bool is_empty(std::size_t layer) const { return layers_[layer].back().depths.front() == 0.0f; }

 private:
  struct Level {
    int side = 0;  // cells
    std::vector<float> depths;
  };
  // The finest first, each next one of half the side, down to one cell.
  using Pyramid = std::vector<Level>;
  static Pyramid pyramid(Level finest);
  Level make_finest() const;

  double cells_per_side_ = 1.0;  // fractional if a cell's side does not divide the map's
  std::vector<Pyramid> layers_;
};

}  // namespace amalgam::passes
