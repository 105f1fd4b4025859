// A shell command that renders a frame again, for the report of a check that failed in it.
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
  int repeat = 1;  // equal frames to render in a row; above 1, nothing moves between them
  bool keep_provenance = false;
  bool keep_buffers = false;
  bool environment_replaced = false;  // by a client's
};

// The command writes poses.json to the current folder, and calibration.json unless the camera is
// common::default_camera(). Then it runs amalgam-render. Comments below it say what the replay
// lacks: always the camera's picture, which is grey instead.
std::string replay_text(const ReplayedFrame& frame);

}  // namespace amalgam::frame
