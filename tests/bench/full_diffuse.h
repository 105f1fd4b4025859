// Settings with which the diffuse pass shades every pixel: the yardstick of what leaving out by
// tile brings.
#pragma once

#include "frame/renderer_settings.h"

namespace amalgam::bench {

frame::RendererSettings with_full_diffuse_pass(frame::RendererSettings settings);

}  // namespace amalgam::bench
