// The markers that a scene needs on paper.
#pragma once

#include "scene/scene.h"
#include "sheet/marker_sheet.h"

namespace amalgam::tools {

// All markers that something in the scene stands on, the world marker first. Throws
// std::runtime_error if the scene's dictionary is none of OpenCV's.
sheet::SheetOptions markers_of(const scene::Scene& scene);

}  // namespace amalgam::tools
