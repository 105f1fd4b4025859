#include "tracking/pose_smoother.h"

namespace amalgam::tracking {

std::vector<common::MarkerPose> PoseSmoother::smooth(std::vector<common::MarkerPose> poses,
                                                     Time captured_at) {
  ++images_;
  std::erase_if(tracks_,
                [&](const auto& entry) { return images_ - entry.second.image > kMaxMissed + 1; });
  for (common::MarkerPose& pose : poses) {
    ++poses_;
    const auto found = tracks_.find(pose.marker);
    if (found != tracks_.end()) {
      found->second.image = images_;
      follow(found->second, pose, captured_at);
      continue;
    }
    Track track{OneEuroPosition(options_),
                OneEuroRotation(options_),
                pose,
                pose,
                {},
                {},
                captured_at,
                images_};
    track.position.filter(pose.translation, 0.0);
    track.rotation.filter(pose.rotation, 0.0);
    tracks_.emplace(pose.marker, std::move(track));
  }
  return poses;
}

void PoseSmoother::follow(Track& track, common::MarkerPose& pose, Time captured_at) {
  const double seconds = std::chrono::duration<double>(captured_at - track.at).count();
  if (!(seconds > 0)) return;
  const common::MarkerPose raw = pose;
  pose.translation = track.position.filter(raw.translation, seconds);
  pose.rotation = track.rotation.filter(raw.rotation, seconds);

  const auto turn = [](const common::MarkerPose& from, const common::MarkerPose& to) {
    return rotation_vector(to.rotation * glm::conjugate(from.rotation));
  };
  const Step moved{raw.translation - track.raw.translation,
                   pose.translation - track.smoothed.translation};
  const Step turned{turn(track.raw, raw), turn(track.smoothed, pose)};
  if (track.moved && track.turned) {
    positions_.add_jitter(moved.raw - track.moved->raw, moved.smoothed - track.moved->smoothed);
    rotations_.add_jitter(turned.raw - track.turned->raw, turned.smoothed - track.turned->smoothed);
  }
  positions_.add_lag(raw.translation - pose.translation, moved.smoothed / seconds);
  rotations_.add_lag(turn(pose, raw), turned.smoothed / seconds);
  track.raw = raw;
  track.smoothed = pose;
  track.moved = moved;
  track.turned = turned;
  track.at = captured_at;
}

SmoothingReport PoseSmoother::report() const {
  return {poses_, positions_.figures(), rotations_.figures()};
}

}  // namespace amalgam::tracking
