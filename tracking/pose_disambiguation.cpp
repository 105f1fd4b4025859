#include "tracking/pose_disambiguation.h"

namespace amalgam::tracking {

std::optional<common::MarkerPose> PoseDisambiguation::previous(std::uint64_t frame) const {
  if (!previous_ || frame - previous_frame_ > kMaxAge) return std::nullopt;
  return previous_;
}

std::optional<common::MarkerPose> PoseDisambiguation::choose(
    std::span<const PoseSolution> solutions, std::uint64_t frame) {
  if (solutions.empty()) return std::nullopt;
  const PoseSolution* chosen = &solutions[0];
  const auto last = previous(frame);
  // A frame without the choice does not contradict either.
  if (!last || solutions.size() < 2) frames_against_ = 0;
  if (last && solutions.size() > 1) {
    const PoseSolution& second = solutions[1];
    const bool first_is_nearer = angle_between(last->rotation, chosen->pose.rotation) <=
                                 angle_between(last->rotation, second.pose.rotation);
    const bool clear = second.error > kClearRatio * chosen->error;
    const bool overwhelming = second.error > kOverwhelmingRatio * chosen->error;
    // Counts successive frames that contradict the remembered pose.
    frames_against_ = !first_is_nearer && clear ? frames_against_ + 1 : 0;
    const bool switches = overwhelming || frames_against_ >= kFramesToSwitch;
    if (!first_is_nearer && !switches) chosen = &second;
  }
  if (chosen == &solutions[0] && frames_against_ >= kFramesToSwitch) frames_against_ = 0;
  previous_ = chosen->pose;
  previous_frame_ = frame;
  return previous_;
}

}  // namespace amalgam::tracking
