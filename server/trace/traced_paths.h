// The paths of a whole frame, kept so that an equal frame need not trace them again.
//
// Valid as long as camera, objects, lights, environment and settings are the same. They do not
// depend on the camera image's colors or on the exposure.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/ray_counts.h"
#include "trace/radiance_limit.h"
#include "trace/tile_paths.h"

namespace amalgam::trace {

// Counts of one tile, or of all.
struct PathCounts {
  core::RayCounts rays;
  std::uint64_t samples = 0;
  std::uint64_t primary_virtual = 0,
                // Samples whose first surface is virtual, or specular.
      primary_specular = 0;

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
  RadianceLimit limit;  // without the camera image's colors

  std::size_t bytes() const {
    std::size_t sum = tiles.size() * sizeof(TilePaths);
    for (const TilePaths& tile : tiles) sum += tile.bytes();
    return sum;
  }
};

}  // namespace amalgam::trace
