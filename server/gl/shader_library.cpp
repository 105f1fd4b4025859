#include "gl/shader_library.h"

namespace amalgam::gl {
namespace {

std::string describe(const SceneFeatures& features) {
  const auto define = [](const char* name, bool on) {
    return "#define " + std::string(name) + (on ? " 1\n" : " 0\n");
  };
  return define("HAS_TEXTURES", features.textures) +
         define("HAS_REAL_OPAQUE", features.real_opaque) +
         define("HAS_VIRTUAL_OPAQUE", features.virtual_opaque) +
         define("HAS_REAL_GLASS", features.real_glass) +
         define("HAS_VIRTUAL_GLASS", features.virtual_glass);
}

}  // namespace

ShaderLibrary::ShaderLibrary(const SceneFeatures& features)
    : write_mask("draw_surface.vert", "write_mask.frag", describe(features)),
      shade_diffuse("draw_surface.vert", "shade_diffuse.frag", describe(features)),
      draw_depth("draw_surface.vert", "draw_depth.frag", describe(features)),
      draw_caster("draw_caster.vert", "draw_depth.frag", describe(features)),
      accumulate_glass("draw_caster.vert", "accumulate_glass.frag", describe(features)),
      query_effect("cover_screen.vert", "query_effect.frag"),
      resolve_samples("cover_screen.vert", "resolve_samples.frag") {}

}  // namespace amalgam::gl
