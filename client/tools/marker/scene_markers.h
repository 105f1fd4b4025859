// The markers that a scene needs on paper.
#pragma once

#include "client/tools/marker/marker_sheet.h"
#include "scene/scene.h"

namespace amalgam::tools {

// All markers that something in the scene stands on, the world marker first. Throws
// std::runtime_error if the scene's dictionary is none of OpenCV's.
SheetOptions markers_of(const scene::Scene& scene);

}  // namespace amalgam::tools
