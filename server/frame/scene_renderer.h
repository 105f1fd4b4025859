// Makes the renderers of scenes that a RenderThread serves.
#pragma once

#include <memory>
#include <string>

#include "frame/renderer_settings.h"
#include "frame/view_renderer.h"
#include "scene/scene.h"

namespace amalgam::frame {

// Loads the scene when it is called, on the render thread.
MakeRenderer renderer_of_file(const std::string& scene_path, const RendererSettings& settings);

// Of a scene that is loaded already, so that rendering need not stop for it. May be called once.
MakeRenderer renderer_of_scene(scene::Scene scene, const RendererSettings& settings);

}  // namespace amalgam::frame
