// The rays through all pixels of a camera, row by row: rays to ask for where no frame was recorded.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "common/camera_model.h"
#include "trace/embree_scene.h"

namespace amalgam::bench {

// The camera must have no distortion.
std::vector<trace::Ray> camera_rays(const common::CameraModel& camera,
                                    const glm::dmat4& camera_from_world);

}  // namespace amalgam::bench
