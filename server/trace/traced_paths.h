// The paths of a whole frame, kept so that the next frame need not trace them again.
//
// They hold as long as camera, objects, lights, environment and settings are the same. Colors of
// the camera image and the exposure are not in them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/ray_counts.h"
#include "trace/tile_paths.h"

namespace amalgam::trace {

// What tiles count.
struct PathCounts {
  core::RayCounts rays;
  std::uint64_t samples = 0;
  std::uint64_t primary_virtual = 0,
                primary_specular = 0;  // samples whose first surface is so

  PathCounts& operator+=(const PathCounts& other) {
    rays += other.rays;
    samples += other.samples;
    primary_virtual += other.primary_virtual;
    primary_specular += other.primary_specular;
    return *this;
  }
};

struct TracedPaths {
  glm::ivec2 size{0};  // of the picture, pixels
  int samples_per_side = 1;
  std::vector<TilePaths> tiles;  // by core::TileGrid(size)
  PathCounts counts;

  std::size_t bytes() const {
    std::size_t sum = tiles.size() * sizeof(TilePaths);
    for (const TilePaths& tile : tiles) sum += tile.bytes();
    return sum;
  }
};

}  // namespace amalgam::trace
