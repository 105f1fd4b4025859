// Selects the poses to render a frame with: the usable ones, and for markers with an unusable or
// missing pose the last good one while it is fresh. So objects do not blink at a bad value or a
// marker lost for a moment.
#pragma once

#include <chrono>
#include <map>
#include <vector>

#include "common/pose.h"

namespace amalgam::net {

class PoseHold {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit PoseHold(std::chrono::milliseconds hold) : hold_(hold) {}

  struct Resolved {
    // One for each marker, its first usable one: in the frame's order, then held poses by ascending
    // marker.
    std::vector<common::MarkerPose> poses;
    std::vector<int> rejected;  // markers with an unusable pose, held or not
  };
  Resolved resolve(const std::vector<common::MarkerPose>& poses, Time now);

 private:
  struct Held {
    common::MarkerPose pose;
    Time seen;
  };
  void forget_oldest();

  std::chrono::milliseconds hold_;
  std::map<int, Held> last_good_;  // not older than hold_, not more than fit into a frame
};

}  // namespace amalgam::net
