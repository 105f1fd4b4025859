// The number of threads that render.
#pragma once

#include <string>

#include "frame/renderer_settings.h"

namespace amalgam::frame {

// RendererSettings::threads; for 0 one for each core that this process may use.
int rendering_threads(const RendererSettings& settings);

// Sets the same for Mesa's llvmpipe, which ignores CPU quotas, by LP_NUM_THREADS unless the
// operator did. Call it before the first FrameRenderer and before other threads run, since it
// changes the process's environment variables.
void limit_llvmpipe_threads(const RendererSettings& settings);

// Name and version of the ray tracer, for --version and the admin port (trace/embree_version.h).
std::string ray_tracer_version();

}  // namespace amalgam::frame
