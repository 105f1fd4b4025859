// How a person can make a frame again: for the report of a check that failed while it was rendered.
#pragma once

#include <span>
#include <string>

#include "common/camera_model.h"
#include "common/pose.h"
#include "frame/renderer_settings.h"

namespace amalgam::frame {

struct ReplayedFrame {
  std::string scene_path{};  // empty: unknown
  common::CameraModel camera{};
  std::span<const common::MarkerPose> poses{};
  RendererSettings settings{};
  int repeat = 1;  // how many such frames in a row it takes; above 1, of a camera on a tripod
  bool keep_provenance = false;
  bool keep_buffers = false;
  bool environment_replaced = false;  // by a client's
};

// Lines for a shell: they write poses.json and, unless the camera is common::default_camera(),
// calibration.json into the current folder, and run amalgam-render. What that cannot be told stands
// below in comments: the camera's picture is grey, for one.
std::string replay_text(const ReplayedFrame& frame);

}  // namespace amalgam::frame
