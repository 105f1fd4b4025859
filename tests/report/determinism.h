// Whether pictures have the same bits for any number of threads and any instruction set of Embree
// (numerics B11, B25).
#pragma once

#include <string>
#include <vector>

#include "bench/bench_case.h"
#include "frame/buffer_dump.h"

namespace amalgam::report {

struct LayersHash {
  std::string scene;
  std::string what;  // "3 threads", "avx2"
  std::string hash;  // SHA-256 of the float layers
  // To those of one thread: pixels with any difference, and the largest in any channel.
  std::ptrdiff_t differing_pixels = 0;
  double largest_difference = 0.0;
};

// Of the buffers "over" and "difference".
std::string layers_hash(const frame::FrameBuffers& buffers);

// With 1, 2, 3 and 16 threads, and with each instruction set that this processor has.
std::vector<LayersHash> measure_determinism(const std::string& scene_name,
                                            const bench::BenchCase& bench_case);

// Whether all rows of a scene have the hash of its first.
bool is_deterministic(const std::vector<LayersHash>& rows);

}  // namespace amalgam::report
