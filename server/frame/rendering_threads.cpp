#include "frame/rendering_threads.h"

#include <cstdlib>

#include "core/cpu_count.h"
#include "trace/embree_version.h"

namespace amalgam::frame {

int rendering_threads(const RendererSettings& settings) {
  return settings.threads > 0 ? settings.threads : core::usable_cpus();
}

void limit_llvmpipe_threads(const RendererSettings& settings) {
  const int threads = rendering_threads(settings);
  // Mesa counts threads besides the one that calls OpenGL, which waits for them. 0 means none, and
  // is Mesa's own choice on one core.
  const std::string value = threads > 1 ? std::to_string(threads) : "0";
  constexpr int kKeepWhatIsSet = 0;
  setenv("LP_NUM_THREADS", value.c_str(), kKeepWhatIsSet);
}

std::string ray_tracer_version() {
  return trace::embree_version();
}

}  // namespace amalgam::frame
