// A tile's finished samples become its pixels' share of the layers.
#pragma once

#include "trace/tile_paths.h"
#include "trace/trace_request.h"

namespace amalgam::trace {

// Eq. 4.5 per sample, each with weight 1/n^2 (core/layers.h), n being samples_per_side. Fills
// result.images if they are there. Non-finite values become 0; returns how many did. Tiles share no
// pixel, so different tiles may be resolved by different threads.
std::uint64_t resolve_tile(std::size_t tile, const TilePaths& paths, int samples_per_side,
                           float exposure, TraceResult& result);

}  // namespace amalgam::trace
