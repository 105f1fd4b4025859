// Resolves a tile's finished samples into the layers.
#pragma once

#include "core/truncation.h"
#include "trace/radiance_limit.h"
#include "trace/tile_paths.h"
#include "trace/trace_request.h"

namespace amalgam::trace {

struct ResolvedTile {
  std::uint64_t nonfinite = 0;  // sample values replaced by 0
  core::TruncationBound truncation;

  ResolvedTile& operator+=(const ResolvedTile& other) {
    nonfinite += other.nonfinite;
    truncation += other.truncation;
    return *this;
  }
};

// Each sample with weight 1/n^2 (core/layers.h), n = samples_per_side. Also fills
// result.images if it is set. Non-finite values become 0. Tiles share no pixel, so different
// threads may resolve different tiles. limit: with the camera image's colors, if they were looked
// up.
ResolvedTile resolve_tile(std::size_t tile, const TilePaths& paths, const RadianceLimit& limit,
                          int samples_per_side, const scene::ToneMap& tone_map,
                          scene::RealSurfaces real_surfaces, TraceResult& result);

}  // namespace amalgam::trace
