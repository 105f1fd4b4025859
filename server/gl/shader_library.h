// All programs of the renderer. They are compiled at start-up, so that a broken shader stops the
// server then and not in some frame.
#pragma once

#include <optional>

#include "gl/gpu_scene.h"
#include "gl/shader_program.h"

namespace amalgam::gl {

// Two variants of a program for surfaces: plain ones, and ones with textures or vertex colors (if
// the scene has any). Each variant serves all such surfaces, without features that the scene lacks.
struct SurfaceProgram {
  ShaderProgram plain;
  std::optional<ShaderProgram> detailed;
};

struct ShaderLibrary {
  // Features that the scene lacks are left out of the shaders' code.
  explicit ShaderLibrary(const ShaderFeatures& features);

  SurfaceProgram write_mask;
  // Both solutions of diffuse surfaces: under any lights; under at most kFewSuns directional ones;
  // and, under those, of a lone real plane (ShaderFeatures).
  SurfaceProgram shade_diffuse;
  SurfaceProgram shade_under_few_suns;
  SurfaceProgram shade_lone_plane;
  SurfaceProgram draw_depth;        // from the camera
  SurfaceProgram draw_caster;       // depth from a light
  SurfaceProgram accumulate_glass;  // optical depth from a light
};

}  // namespace amalgam::gl
