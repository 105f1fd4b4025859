// The media that a point lies in: what the camera's rays start with.
#pragma once

#include <glm/vec3.hpp>

#include "trace/embree_scene.h"
#include "trace/media.h"

namespace amalgam::trace {

// A way out of everything leaves each solid around the point once more than it enters it. If ways
// in different directions do not agree there are open surfaces about, and the point counts as lying
// in air.
Media media_at(const EmbreeScene& scene, const glm::vec3& point);

}  // namespace amalgam::trace
