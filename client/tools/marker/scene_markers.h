// The markers that a scene needs on paper.
#pragma once

#include "scene/scene.h"
#include "sheet/marker_sheet.h"

namespace amalgam::tools {

// All markers that something in the scene stands on, the world marker first.
sheet::SheetOptions markers_of(const scene::Scene& scene);

}  // namespace amalgam::tools
