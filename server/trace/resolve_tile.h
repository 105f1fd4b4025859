// Resolves a tile's finished samples into the layers.
#pragma once

#include "trace/tile_paths.h"
#include "trace/trace_request.h"

namespace amalgam::trace {

// Eq. 4.5 per sample with weight 1/n^2 (core/layers.h), n = samples_per_side. Also fills
// result.images if it is set. Non-finite values become 0; returns their number. Tiles share no
// pixel, so different threads may resolve different tiles.
std::uint64_t resolve_tile(std::size_t tile, const TilePaths& paths, int samples_per_side,
                           float exposure, TraceResult& result);

}  // namespace amalgam::trace
