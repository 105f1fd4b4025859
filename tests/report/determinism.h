// Whether pictures have the same bits for any number of threads (numerics B25).
#pragma once

#include <string>
#include <vector>

#include "bench/bench_case.h"
#include "frame/buffer_dump.h"

namespace amalgam::report {

struct LayersHash {
  std::string scene;
  std::string what;  // "3 threads"
  std::string hash;  // SHA-256 of the float layers
};

// Of the buffers "over" and "difference".
std::string layers_hash(const frame::FrameBuffers& buffers);

// With 1, 2, 3 and 16 threads. Instruction sets join here once the renderer can be told which.
std::vector<LayersHash> measure_determinism(const std::string& scene_name,
                                            const bench::BenchCase& bench_case);

// Whether all rows of a scene have the hash of its first.
bool is_deterministic(const std::vector<LayersHash>& rows);

}  // namespace amalgam::report
