#include "gl/shader_library.h"

#include <string>
#include <string_view>

namespace amalgam::gl {
namespace {

std::string define(const char* name, bool on) {
  return "#define " + std::string(name) + (on ? " 1\n" : " 0\n");
}

SurfaceProgram surface_program(std::string_view vertex_file, std::string_view fragment_file,
                               const SceneFeatures& features) {
  const std::string casters = define("HAS_REAL_OPAQUE", features.real_opaque) +
                              define("HAS_VIRTUAL_OPAQUE", features.virtual_opaque) +
                              define("HAS_REAL_GLASS", features.real_glass) +
                              define("HAS_VIRTUAL_GLASS", features.virtual_glass);
  SurfaceProgram program{
      ShaderProgram(vertex_file, fragment_file, casters + define("TEXTURED", false)), {}};
  if (features.textures) {
    program.textured.emplace(vertex_file, fragment_file, casters + define("TEXTURED", true));
  }
  return program;
}

}  // namespace

ShaderLibrary::ShaderLibrary(const SceneFeatures& features)
    : write_mask(surface_program("draw_surface.vert", "write_mask.frag", features)),
      shade_diffuse(surface_program("draw_surface.vert", "shade_diffuse.frag", features)),
      draw_depth(surface_program("draw_surface.vert", "draw_depth.frag", features)),
      draw_caster(surface_program("draw_caster.vert", "draw_depth.frag", features)),
      accumulate_glass(surface_program("draw_caster.vert", "accumulate_glass.frag", features)),
      query_effect("cover_screen.vert", "query_effect.frag"),
      resolve_samples("cover_screen.vert", "resolve_samples.frag") {}

}  // namespace amalgam::gl
