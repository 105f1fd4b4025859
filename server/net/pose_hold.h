// Which poses of a frame may be rendered with: the usable ones, and for a marker whose pose is
// unusable or missing the last good one as long as it is fresh, so that neither a bad value nor a
// marker lost for a moment makes an object blink.
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
    // In the frame's order, then those held in ascending order of markers; one for each marker,
    // the first usable one.
    std::vector<common::MarkerPose> poses;
    std::vector<int> rejected;  // markers whose pose is unusable, whether held or not
  };
  Resolved resolve(const std::vector<common::MarkerPose>& poses, Time now);

 private:
  struct Held {
    common::MarkerPose pose;
    Time seen;
  };
  void forget_oldest();

  std::chrono::milliseconds hold_;
  std::map<int, Held> last_good_;  // never older than hold_, never more than fit into a frame
};

}  // namespace amalgam::net
