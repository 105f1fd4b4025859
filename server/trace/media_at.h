// The media around a point: those that the camera's rays start in.
#pragma once

#include <glm/vec3.hpp>

#include "trace/embree_scene.h"
#include "trace/media.h"

namespace amalgam::trace {

// A ray from the point to infinity leaves each solid around the point once more often than it
// enters it. If rays in four directions disagree, a mesh is open, and the point counts as lying in
// air.
Media media_at(const EmbreeScene& scene, const glm::vec3& point);

}  // namespace amalgam::trace
