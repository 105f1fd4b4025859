// The scene that a renderer mode really draws (section 6.3 of the thesis compares these).
#pragma once

#include "frame/renderer_settings.h"
#include "scene/scene.h"

namespace amalgam::frame {

// Raster: without its specular instances. Diffuse: specular materials become diffuse ones of the
// same base color. Otherwise as it is.
scene::Scene scene_variant(scene::Scene scene, RendererMode mode);

}  // namespace amalgam::frame
