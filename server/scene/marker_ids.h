// The markers that a scene's objects stand on.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace amalgam::scene {

// The world marker first, then the others that objects are bound to, ascending.
std::vector<int> marker_ids(const Scene& scene);

}  // namespace amalgam::scene
