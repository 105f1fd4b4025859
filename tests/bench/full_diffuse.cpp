#include "bench/full_diffuse.h"

namespace amalgam::bench {

frame::RendererSettings with_full_diffuse_pass(frame::RendererSettings settings) {
  settings.leave_out_tiles = false;
  return settings;
}

}  // namespace amalgam::bench
