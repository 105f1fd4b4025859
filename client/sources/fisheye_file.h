// Reads the calibration of a fish-eye lens; its fields are listed in environment_message.h.
#pragma once

#include <filesystem>
#include <glm/gtc/quaternion.hpp>

#include "common/fisheye_model.h"

namespace amalgam::client {

struct FisheyeCalibration {
  common::FisheyeModel lens;  // for images of the requested size
  glm::dquat world_from_fisheye{1.0, 0.0, 0.0, 0.0};
};

// For an image of this size, pixels. A calibration of another size is scaled if the aspect ratio is
// the same to within one pixel. Throws std::runtime_error with one line.
FisheyeCalibration load_fisheye(const std::filesystem::path& file, int width, int height);

}  // namespace amalgam::client
