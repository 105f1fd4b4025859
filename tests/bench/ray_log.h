// The rays that a frame's tracer asked of Embree.
#pragma once

#include <optional>
#include <vector>

#include "bench/bench_case.h"
#include "frame/renderer_settings.h"

#if __has_include("trace/ray_log.h")
#include "trace/ray_log.h"
#else
#include "trace/embree_scene.h"

// What the tracer will declare; until then nothing records.
namespace amalgam::trace {

struct LoggedRay {
  Ray ray;
  Visible visible = Visible::Everything;
  bool any_hit = false;  // only asked whether there is a hit
};

struct RayLog {
  std::vector<LoggedRay> rays;  // in the order of tiles
};

}  // namespace amalgam::trace
#endif

namespace amalgam::bench {

// Renders the case and records the last frame's rays; nothing if the renderer cannot record.
std::optional<trace::RayLog> record_rays(const BenchCase& bench_case);

}  // namespace amalgam::bench
