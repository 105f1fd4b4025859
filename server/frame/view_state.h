// The state of one client's camera from frame to frame.
#pragma once

#include <memory>
#include <optional>

#include "common/camera_model.h"
#include "frame/frame.h"
#include "frame/governor.h"
#include "frame/still_frame.h"
#include "frame/surroundings.h"
#include "passes/image/exposure.h"
#include "passes/image/warp.h"

namespace amalgam::frame {

// Throws std::invalid_argument if the view cannot be rendered.
void check_view(const ViewOptions& options);

struct ViewState {
  // Throws as check_view().
  explicit ViewState(const ViewOptions& options);

  ViewOptions options;
  // The ideal camera at full size: no distortion, with margins.
  common::CameraModel ideal;
  std::optional<passes::WarpMap> warp_map;  // only if the lens distorts
  passes::ExposureMemory exposure;
  StillView still;
  std::shared_ptr<Surroundings> own_surroundings;  // null: the scene's
  std::optional<Governor> governor;  // only with a target frame rate; made by the first frame
};

}  // namespace amalgam::frame
