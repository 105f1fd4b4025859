// Chooses between a marker's two possible poses, so that virtual objects do not flip over from one
// frame to the next (numerics B22).
//
// One object serves one marker. Without a previous pose, takes the solution with the smaller error.
// With one, takes the solution nearest to it, unless the other is clearly better: its error is less
// than half in several successive frames, or less than a tenth in one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "tracking/pose_solution.h"

namespace amalgam::tracking {

class PoseDisambiguation {
 public:
  // The chosen solution's pose, kept as the previous one; nothing if there are no solutions. frame
  // counts images, not detections: a previous pose older than kMaxAge images is dropped.
  std::optional<common::MarkerPose> choose(std::span<const PoseSolution> solutions,
                                           std::uint64_t frame);

  // The pose chosen last, unless it is too old by this frame.
  std::optional<common::MarkerPose> previous(std::uint64_t frame) const;

  static constexpr double kClearRatio = 2.0;          // B22: second error / first error
  static constexpr double kOverwhelmingRatio = 10.0;  // switches at once
  static constexpr int kFramesToSwitch = 3;           // successive, clear but not overwhelming
  static constexpr std::uint64_t kMaxAge = 30;        // images: a second at 30 Hz

 private:
  std::optional<common::MarkerPose> previous_;
  std::uint64_t previous_frame_ = 0;
  int frames_against_ = 0;
};

}  // namespace amalgam::tracking
