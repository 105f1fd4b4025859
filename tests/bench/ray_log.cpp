#include "bench/ray_log.h"

#include "bench/render_rig.h"

namespace amalgam::bench {

trace::RayLog record_rays(const BenchCase& bench_case) {
  trace::RayLog log;
  frame::RendererSettings settings = default_settings();
  settings.ray_log = &log;
  RenderRig rig(bench_case, settings);
  log.rays.clear();  // the first frame's
  rig.render();
  return log;
}

}  // namespace amalgam::bench
