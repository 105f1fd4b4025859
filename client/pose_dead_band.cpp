#include "client/pose_dead_band.h"

#include <glm/geometric.hpp>

namespace amalgam::client {

std::vector<core::MarkerPose> PoseDeadBand::hold(std::vector<core::MarkerPose> poses) {
  std::map<int, core::MarkerPose> next;
  for (core::MarkerPose& pose : poses) {
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

bool PoseDeadBand::is_within(const core::MarkerPose& a, const core::MarkerPose& b) const {
  if (!core::is_usable(a) || !core::is_usable(b)) return false;
  const glm::dmat4 from_a = core::to_matrix(a), from_b = core::to_matrix(b);
  const double half = 0.5 * marker_length_;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {0.0, marker_length_}) {  // out of the paper
        const glm::dvec4 corner(x, y, z, 1.0);
        const auto at_a = core::project(camera_, glm::dvec3(from_a * corner));
        const auto at_b = core::project(camera_, glm::dvec3(from_b * corner));
        if (!at_a || !at_b || glm::distance(*at_a, *at_b) > pixels_) return false;
      }
    }
  }
  return true;
}

}  // namespace amalgam::client
