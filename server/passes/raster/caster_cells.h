// A coarse picture of what casts shadows, made once when a shadow map is drawn: for cells of
// kCellTexels x kCellTexels texels of each layer the depth of the caster that is nearest to the
// light. What is nearer to the light than that, over all cells around it, is not in a shadow.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "gl/texture.h"

namespace amalgam::passes {

class CasterCells {
 public:
  static constexpr int kCellTexels = 8;  // of an opaque map; glass maps have half the side

  // Of a map of opaque casters (depth) or of glass (depth in alpha), as ShadowMap has them.
  // map_size: texels a side of the opaque maps. Reads the map back.
  static CasterCells of(const gl::Texture& map, int map_size);

  // For tests: one layer from the depths of map_size x map_size texels.
  static CasterCells of_depths(const std::vector<float>& depths, int map_size);

  // The greatest reversed depth in [low, high] of a layer, in units of the map's side, [0, 1]
  // inside; 0 where nothing casts. Never less than what a look-up within finds.
  float nearest_depth(std::size_t layer, glm::dvec2 low, glm::dvec2 high) const;
  bool is_empty(std::size_t layer) const { return layers_[layer].back().depths.front() == 0.0f; }

 private:
  struct Level {
    int side = 0;  // cells
    std::vector<float> depths;
  };
  using Pyramid =
      std::vector<Level>;  // the finest first, then half the side each, down to one cell
  static Pyramid pyramid(Level finest);
  Level make_finest() const;

  double cells_per_side_ = 1.0;  // not whole if the map's side is not a multiple of a cell's
  std::vector<Pyramid> layers_;
};

}  // namespace amalgam::passes
