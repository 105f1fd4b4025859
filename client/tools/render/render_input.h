// amalgam-render's input besides the scene: a camera image, its calibration and poses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "frame/frame.h"
#include "scene/scene.h"

namespace amalgam::tools {

struct RenderInputOptions {
  std::optional<std::filesystem::path> camera_image;
  std::optional<std::filesystem::path> calibration;
  std::optional<std::filesystem::path> poses;
  int width = 640, height = 480;  // pixels, without a camera image
};

struct RenderInput {
  common::CameraModel camera;
  frame::FrameInput frame;
  bool detected = false;  // poses come from markers found in the image
};

// Without an image: mid grey, from a fixed place above the world marker. Without poses: detects the
// scene's markers in the image. Throws std::runtime_error with one line.
RenderInput load_render_input(const RenderInputOptions& options, const scene::Scene& scene);

// Why nothing of the scene will show: no pose is one of its markers'. Empty if one is.
std::string describe_missing_markers(const RenderInput& input, const scene::Scene& scene);

}  // namespace amalgam::tools
