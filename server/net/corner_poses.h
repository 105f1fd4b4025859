// Poses of the markers whose corners a client sent, solved as the native client solves them: both
// solutions of each marker weighed over time, then smoothed if the client asked for it.
#pragma once

#include <google/protobuf/repeated_ptr_field.h>
#include <chrono>
#include <optional>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "frame/frame.h"
#include "protocol/amalgam.pb.h"
#include "tracking/pose_smoother.h"
#include "tracking/pose_tracker.h"

namespace amalgam::net {

class CornerPoses {
 public:
  using Corners = google::protobuf::RepeatedPtrField<protocol::MarkerCorners>;
  using Time = std::chrono::steady_clock::time_point;

  // Throws ClientError (BAD_HELLO) for a smoothing that is none. The camera has no defect.
  CornerPoses(const protocol::Hello& hello, const common::CameraModel& camera);

  struct Solved {
    std::vector<common::MarkerPose> poses;  // camera_from_marker, by ascending marker
    std::vector<int> rejected;              // markers whose corners are not four places
  };
  // Of one frame, captured at this time. Solves the markers that the scene wants and no others.
  Solved solve(const Corners& corners, const frame::FrameService::MarkerSet& wanted, Time captured);

 private:
  common::CameraModel camera_;
  std::optional<tracking::PoseSmoother> smoother_;
  std::optional<tracking::PoseTracker> tracker_;  // from the first frame with corners on
  frame::FrameService::MarkerSet tracked_;        // what it was made for
};

}  // namespace amalgam::net
