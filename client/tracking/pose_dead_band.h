// Repeats a marker's last pose while the new one would not visibly move anything.
//
// On a tripod, detected poses jitter by a fraction of a pixel. With a dead band the objects stand
// still, and the server only looks up the camera's new colors.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"

namespace amalgam::client {

class PoseDeadBand {
 public:
  // pixels: how far the image of a point on the marker, or up to one marker's length above it, may
  // move before the new pose is taken. marker_length: metres.
  PoseDeadBand(double pixels, double marker_length, const common::CameraModel& camera)
      : pixels_(pixels), marker_length_(marker_length), camera_(camera) {}

  // poses: of one image. A missing marker loses its last pose.
  std::vector<common::MarkerPose> hold(std::vector<common::MarkerPose> poses);

  std::uint64_t held() const { return held_; }  // poses replaced by the last one

 private:
  bool is_within(const common::MarkerPose& a, const common::MarkerPose& b) const;

  double pixels_, marker_length_;
  common::CameraModel camera_;
  std::map<int, common::MarkerPose> last_;
  std::uint64_t held_ = 0;
};

}  // namespace amalgam::client
