// All programs of the renderer, compiled in one place at start-up, so that a broken shader stops
// the server there and not in some frame.
#pragma once

#include <optional>

#include "gl/gpu_scene.h"
#include "gl/shader_program.h"

namespace amalgam::gl {

// A program for surfaces, and one that also reads their textures and vertex colors, if the scene
// has any: of both programs one for all surfaces, with what the scene lacks left out.
struct SurfaceProgram {
  ShaderProgram plain;
  std::optional<ShaderProgram> detailed;
};

struct ShaderLibrary {
  // Features that the scene lacks are left out of the shaders' code.
  explicit ShaderLibrary(const ShaderFeatures& features);

  SurfaceProgram write_mask;
  // Both solutions of diffuse surfaces under any lights; under at most kFewSuns directional ones;
  // and under those of a lone real plane (ShaderFeatures).
  SurfaceProgram shade_diffuse;
  SurfaceProgram shade_under_few_suns;
  SurfaceProgram shade_lone_plane;
  SurfaceProgram draw_depth;        // from the camera
  SurfaceProgram draw_caster;       // depth from a light
  SurfaceProgram accumulate_glass;  // optical depth from a light
};

}  // namespace amalgam::gl
