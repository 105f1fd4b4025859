#include "bench/ray_log.h"

#include "bench/render_rig.h"

namespace amalgam::bench {
namespace {

template <typename Settings>
constexpr bool kCanRecord = requires(Settings settings, trace::RayLog log) {
  settings.ray_log = &log;
};

// A template, so that it compiles before the renderer has the member.
template <typename Settings>
std::optional<trace::RayLog> record(const BenchCase& bench_case, Settings settings) {
  if constexpr (kCanRecord<Settings>) {
    trace::RayLog log;
    settings.ray_log = &log;
    RenderRig rig(bench_case, settings);
    log.rays.clear();  // the first frame's
    rig.render();
    return log;
  } else {
    return std::nullopt;
  }
}

}  // namespace

std::optional<trace::RayLog> record_rays(const BenchCase& bench_case) {
  return record(bench_case, default_settings());
}

}  // namespace amalgam::bench
