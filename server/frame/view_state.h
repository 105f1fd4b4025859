// What one client's camera keeps from frame to frame.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "core/camera_model.h"
#include "core/image.h"
#include "frame/frame.h"
#include "passes/exposure.h"

namespace amalgam::frame {

struct ViewState {
  // Throws std::invalid_argument if the camera cannot be rendered with.
  explicit ViewState(const ViewOptions& options);

  ViewOptions options;
  core::CameraModel ideal;                         // what is rendered: no distortion, with margins
  std::optional<core::Image<glm::vec2>> warp_map;  // only if the lens distorts
  passes::ExposureMemory exposure;
};

}  // namespace amalgam::frame
