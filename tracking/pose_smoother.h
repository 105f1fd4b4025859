// Smooths the poses of all markers before they are sent, and measures the effect.
//
// Each marker has its own One-Euro filters, for position and rotation in the camera's frame. A
// marker unseen for more than kMaxMissed images starts anew. Images and not time, so that slow
// cameras are smoothed too.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/pose.h"
#include "tracking/motion_figures.h"
#include "tracking/one_euro.h"

namespace amalgam::tracking {

struct SmoothingReport {
  std::uint64_t poses = 0;
  MotionFigures position;  // metres, seconds
  MotionFigures rotation;  // radians, seconds
};

class PoseSmoother {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::uint64_t kMaxMissed = 8;  // a quarter of a second at 30 Hz

  explicit PoseSmoother(const OneEuroOptions& options) : options_(options) {}

  // poses: of one image, captured at this time. Times that do not advance leave poses raw.
  std::vector<common::MarkerPose> smooth(std::vector<common::MarkerPose> poses, Time captured_at);

  SmoothingReport report() const;

 private:
  struct Step {  // from one value to the next
    glm::dvec3 raw, smoothed;
  };
  struct Track {
    OneEuroPosition position;
    OneEuroRotation rotation;
    common::MarkerPose raw, smoothed;  // the last
    std::optional<Step> moved, turned;
    Time at;
    std::uint64_t image = 0;  // in which it was seen last
  };
  void follow(Track& track, common::MarkerPose& pose, Time captured_at);

  OneEuroOptions options_;
  std::map<int, Track> tracks_;
  MotionMeter positions_, rotations_;
  std::uint64_t poses_ = 0, images_ = 0;
};

}  // namespace amalgam::tracking
