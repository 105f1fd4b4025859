// Frames from the synthetic camera.
#pragma once

#include "client/sources/camera_source.h"
#include "client/synthetic/synthetic_camera.h"

namespace amalgam::client {

class SyntheticSource : public CameraSource {
 public:
  // with_true_poses: frames carry the exact pose; otherwise it has to be detected.
  SyntheticSource(const common::CameraModel& camera, bool with_true_poses, int jpeg_quality,
                  std::optional<DeskMirror> mirror = {})
      : camera_(camera, std::make_shared<const SyntheticDesk>(PrintedMarker{}, mirror)),
        with_true_poses_(with_true_poses),
        jpeg_quality_(jpeg_quality) {}

  cv::Size size() const override { return {camera_.camera().width, camera_.camera().height}; }
  std::optional<CapturedFrame> next() override;
  std::optional<common::CameraModel> own_camera() const override { return camera_.camera(); }

 private:
  SyntheticCamera camera_;
  bool with_true_poses_;
  int jpeg_quality_;
  std::uint64_t frame_ = 0;
};

}  // namespace amalgam::client
