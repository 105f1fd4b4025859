#include "client/tracking/pose_dead_band.h"

#include <glm/geometric.hpp>

namespace amalgam::client {

std::vector<common::MarkerPose> PoseDeadBand::hold(std::vector<common::MarkerPose> poses) {
  std::map<int, common::MarkerPose> next;
  for (common::MarkerPose& pose : poses) {
    const auto found = last_.find(pose.marker);
    if (found != last_.end() && is_within(found->second, pose)) {
      pose = found->second;
      ++held_;
    }
    next.emplace(pose.marker, pose);
  }
  last_ = std::move(next);
  return poses;
}

bool PoseDeadBand::is_within(const common::MarkerPose& a, const common::MarkerPose& b) const {
  if (!common::is_usable(a) || !common::is_usable(b)) return false;
  const glm::dmat4 from_a = common::to_matrix(a), from_b = common::to_matrix(b);
  const double half = 0.5 * marker_length_;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {0.0, marker_length_}) {  // out of the paper
        const glm::dvec4 corner(x, y, z, 1.0);
        const auto at_a = common::project(camera_, glm::dvec3(from_a * corner));
        const auto at_b = common::project(camera_, glm::dvec3(from_b * corner));
        if (!at_a || !at_b || glm::distance(*at_a, *at_b) > pixels_) return false;
      }
    }
  }
  return true;
}

}  // namespace amalgam::client
