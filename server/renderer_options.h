// The renderer's settings as command line options, the same for every program that renders.
#pragma once

#include <string>

#include "frame/renderer_settings.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace amalgam::tools {

// Adds the options of frame/settings_options.h, which has the reverse conversion. The settings must
// outlive parsing; wrong values end parsing with a message.
void add_renderer_options(CLI::App& app, frame::RendererSettings& settings);

// The complex scene: beside the build tree (deploy/scenes in the source) or installed
// (share/amalgam/scenes).
std::string default_scene_path();

}  // namespace amalgam::tools
