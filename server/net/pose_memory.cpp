#include "net/pose_memory.h"

namespace amalgam::net {

PoseMemory::Resolved PoseMemory::resolve(const std::vector<core::MarkerPose>& poses, Time now) {
  std::erase_if(last_good_, [&](const auto& entry) { return now - entry.second.seen > hold_; });
  Resolved resolved;
  for (const core::MarkerPose& pose : poses) {
    if (core::is_usable(pose)) {
      last_good_[pose.marker] = {pose, now};
      resolved.poses.push_back(pose);
      continue;
    }
    resolved.rejected.push_back(pose.marker);
    const auto held = last_good_.find(pose.marker);
    if (held != last_good_.end()) resolved.poses.push_back(held->second.pose);
  }
  return resolved;
}

}  // namespace amalgam::net
