// How many threads render.
#pragma once

#include <string>

#include "frame/renderer_settings.h"

namespace amalgam::frame {

// RendererSettings::threads, or one for each core that this process may use.
int rendering_threads(const RendererSettings& settings);

// The same for Mesa's llvmpipe, which knows of affinity but not of CPU quotas: sets LP_NUM_THREADS
// unless the operator did. Only before the first FrameRenderer, and before other threads run, since
// it changes the environment.
void limit_llvmpipe_threads(const RendererSettings& settings);

// What traces, for --version and the admin port (trace/embree_version.h).
std::string ray_tracer_version();

}  // namespace amalgam::frame
