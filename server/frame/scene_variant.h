// The scene as a renderer mode draws it (section 6.3 of the thesis compares these).
#pragma once

#include "frame/renderer_settings.h"
#include "scene/scene.h"

namespace amalgam::frame {

// Raster: without its specular instances. Diffuse: specular materials become diffuse, with the same
// base color. Other modes: unchanged.
scene::Scene scene_variant(scene::Scene scene, RendererMode mode);

}  // namespace amalgam::frame
