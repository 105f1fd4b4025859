// A source of camera images: a device, a film, files or the synthetic camera.
#pragma once

#include <chrono>
#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"

namespace amalgam::client {

using Bytes = std::vector<unsigned char>;

struct CapturedFrame {
  Bytes jpeg;   // to be sent: baseline, of the source's size
  cv::Mat bgr;  // the same image as pixels, for finding markers
  std::chrono::steady_clock::time_point captured_at;
  std::optional<std::vector<common::MarkerPose>> true_poses;  // from a synthetic camera only
};

class CameraSource {
 public:
  virtual ~CameraSource() = default;

  // Pixels; the same for every frame.
  virtual cv::Size size() const = 0;

  // The next frame, or nothing at the end. Waits for a device; files come as fast as they are read.
  // Throws std::runtime_error if a frame cannot be read or has another size.
  virtual std::optional<CapturedFrame> next() = 0;

  // True if the source sets the pace of frames, false if the reader does.
  virtual bool is_live() const { return false; }

  // The lens, if the source knows it better than any calibration file.
  virtual std::optional<common::CameraModel> own_camera() const { return std::nullopt; }
};

}  // namespace amalgam::client
