#include "net/pose_hold.h"

#include <algorithm>
#include <set>

#include "protocol/limits.h"

namespace amalgam::net {

PoseHold::Resolved PoseHold::resolve(const std::vector<common::MarkerPose>& poses, Time now) {
  std::erase_if(last_good_, [&](const auto& entry) { return now - entry.second.seen > hold_; });
  Resolved resolved;
  std::set<int> seen;
  for (const common::MarkerPose& pose : poses) {
    if (!common::is_usable(pose)) {
      resolved.rejected.push_back(pose.marker);
    } else if (seen.insert(pose.marker).second) {
      last_good_[pose.marker] = {pose, now};
      resolved.poses.push_back(pose);
    }
  }
  forget_oldest();
  for (const auto& [marker, held] : last_good_) {
    if (!seen.contains(marker)) resolved.poses.push_back(held.pose);
  }
  return resolved;
}

// Whoever names other markers in every frame must not fill the memory, nor the renderer's list.
void PoseHold::forget_oldest() {
  while (last_good_.size() > protocol::kMaxPoses) {
    last_good_.erase(std::ranges::min_element(last_good_, {},
                                              [](const auto& entry) { return entry.second.seen; }));
  }
}

}  // namespace amalgam::net
