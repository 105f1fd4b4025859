// Which poses of a frame may be rendered with: the usable ones, and for a marker whose pose is
// unusable the last good one as long as it is fresh, so that one bad value does not make an object
// blink.
#pragma once

#include <chrono>
#include <map>
#include <vector>

#include "core/pose.h"

namespace amalgam::net {

class PoseMemory {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit PoseMemory(std::chrono::milliseconds hold) : hold_(hold) {}

  struct Resolved {
    std::vector<core::MarkerPose> poses;
    std::vector<int> rejected;  // markers whose pose is unusable, whether held or not
  };
  Resolved resolve(const std::vector<core::MarkerPose>& poses, Time now);

 private:
  struct Held {
    core::MarkerPose pose;
    Time seen;
  };
  std::chrono::milliseconds hold_;
  std::map<int, Held>
      last_good_;  // never older than hold_, hence no larger than some frames' poses
};

}  // namespace amalgam::net
