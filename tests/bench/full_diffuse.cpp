#include "bench/full_diffuse.h"

namespace amalgam::bench {
namespace {

// A template, so that it compiles before the renderer has the member; until then its diffuse pass
// shades every pixel anyway.
template <typename Settings>
Settings shade_every_pixel(Settings settings) {
  if constexpr (requires { settings.leave_out_tiles = false; }) settings.leave_out_tiles = false;
  return settings;
}

}  // namespace

frame::RendererSettings with_full_diffuse_pass(const frame::RendererSettings& settings) {
  return shade_every_pixel(settings);
}

}  // namespace amalgam::bench
