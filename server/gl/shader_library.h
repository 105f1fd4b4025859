// All programs of the renderer, compiled in one place at start-up, so that a broken shader stops
// the server there and not in some frame.
#pragma once

#include "gl/gpu_scene.h"
#include "gl/shader_program.h"

namespace amalgam::gl {

struct ShaderLibrary {
  // Features that the scene lacks are left out of the shaders' code.
  explicit ShaderLibrary(const SceneFeatures& features);

  ShaderProgram write_mask;
  ShaderProgram shade_diffuse;
  ShaderProgram draw_depth;        // from the camera
  ShaderProgram draw_caster;       // depth from a light
  ShaderProgram accumulate_glass;  // optical depth from a light
  ShaderProgram query_effect;
  ShaderProgram resolve_samples;
};

}  // namespace amalgam::gl
