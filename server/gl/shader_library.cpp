#include "gl/shader_library.h"

#include <string>
#include <string_view>

#include "gl/shader_interface.h"

namespace amalgam::gl {
namespace {

std::string define(const char* name, bool on) {
  return "#define " + std::string(name) + (on ? " 1\n" : " 0\n");
}

static_assert(kFewSuns == 8, "shade_diffuse.frag writes out so many lights one by one");

enum class SeenFrom { Camera, Light };

std::string caster_defines(const ShaderFeatures& features) {
  return define("HAS_REAL_OPAQUE", features.real_opaque) +
         define("HAS_VIRTUAL_OPAQUE", features.virtual_opaque) +
         define("HAS_REAL_GLASS", features.real_glass) +
         define("HAS_VIRTUAL_GLASS", features.virtual_glass);
}

std::string detail_defines(const ShaderFeatures& features) {
  const auto has = [&](scene::TextureSlot slot) { return features.has_texture(slot); };
  using enum scene::TextureSlot;
  return define("HAS_BASE_COLOR_TEXTURE", has(BaseColor)) +
         define("HAS_METALLIC_ROUGHNESS_TEXTURE", has(MetallicRoughness)) +
         define("HAS_EMISSIVE_TEXTURE", has(Emissive)) +
         define("HAS_TRANSMISSION_TEXTURE", has(Transmission)) +
         define("HAS_NORMAL_TEXTURE", has(Normal)) + define("HAS_SECOND_UVS", features.second_uvs) +
         define("HAS_VERTEX_COLORS", features.vertex_colors);
}

SurfaceProgram surface_program(std::string_view fragment_file, SeenFrom from,
                               const ShaderFeatures& features, const std::string& shading = {}) {
  const bool camera = from == SeenFrom::Camera;
  const std::string_view vertex_file = camera ? "draw_surface.vert" : "draw_caster.vert";
  const std::string common = caster_defines(features) + define("FROM_CAMERA", camera) + shading;
  SurfaceProgram program{
      ShaderProgram(vertex_file, fragment_file, common + detail_defines(ShaderFeatures())), {}};
  if (features.has_details()) {
    program.detailed.emplace(vertex_file, fragment_file, common + detail_defines(features));
  }
  return program;
}

}  // namespace

ShaderLibrary::ShaderLibrary(const ShaderFeatures& features)
    : write_mask(surface_program("write_mask.frag", SeenFrom::Camera, features)),
      shade_diffuse(surface_program("shade_diffuse.frag", SeenFrom::Camera, features,
                                    define("FEW_SUNS", false) + define("IS_LONE_PLANE", false))),
      shade_under_few_suns(
          surface_program("shade_diffuse.frag", SeenFrom::Camera, features,
                          define("FEW_SUNS", true) + define("IS_LONE_PLANE", false))),
      shade_lone_plane(surface_program("shade_diffuse.frag", SeenFrom::Camera, features,
                                       define("FEW_SUNS", true) + define("IS_LONE_PLANE", true))),
      draw_depth(surface_program("draw_depth.frag", SeenFrom::Camera, features)),
      draw_caster(surface_program("draw_depth.frag", SeenFrom::Light, features)),
      accumulate_glass(surface_program("accumulate_glass.frag", SeenFrom::Light, features)) {}

}  // namespace amalgam::gl
