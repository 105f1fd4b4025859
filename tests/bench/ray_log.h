// The rays that a frame's tracer asked of Embree.
#pragma once

#include "bench/bench_case.h"
#include "trace/ray_log.h"

namespace amalgam::bench {

// Renders the case twice and records the second frame's rays.
trace::RayLog record_rays(const BenchCase& bench_case);

}  // namespace amalgam::bench
