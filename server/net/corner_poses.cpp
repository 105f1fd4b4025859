#include "net/corner_poses.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "net/client_error.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

tracking::OneEuroOptions smoothing_from(const protocol::OneEuro& wire) {
  const auto is_a_rate = [](double value) {
    return std::isfinite(value) && value >= 0.0 && value <= protocol::kMaxSmoothing;
  };
  if (!is_a_rate(wire.min_cutoff()) || wire.min_cutoff() == 0.0 || !is_a_rate(wire.beta())) {
    throw ClientError(protocol::Error::BAD_HELLO,
                      "a smoothing whose cut-off is not above 0 Hz, or whose beta is below 0");
  }
  return {.min_cutoff = wire.min_cutoff(), .beta = wire.beta()};
}

// Markers are often cut by the image's edge, but a corner far outside was not seen.
bool is_near_the_image(double pixel, int size) {
  return std::isfinite(pixel) && pixel >= -size && pixel <= 2.0 * size;
}

std::optional<tracking::DetectedMarker> marker_from(const protocol::MarkerCorners& wire,
                                                    const common::CameraModel& camera) {
  tracking::DetectedMarker marker{.id = wire.marker(), .corners = {}};
  if (wire.pixels_size() != 2 * static_cast<int>(marker.corners.size())) return std::nullopt;
  int next = 0;
  for (glm::dvec2& corner : marker.corners) {
    corner.x = wire.pixels(next++);
    corner.y = wire.pixels(next++);
    if (!is_near_the_image(corner.x, camera.width) || !is_near_the_image(corner.y, camera.height)) {
      return std::nullopt;
    }
  }
  return marker;
}

}  // namespace

CornerPoses::CornerPoses(const protocol::Hello& hello, const common::CameraModel& camera)
    : camera_(camera) {
  if (hello.has_smoothing()) smoother_.emplace(smoothing_from(hello.smoothing()));
}

CornerPoses::Solved CornerPoses::solve(const Corners& corners,
                                       const frame::FrameService::MarkerSet& wanted,
                                       Time captured) {
  if (!tracker_ || tracked_ != wanted) {  // another scene may have come
    tracker_.emplace(
        tracking::PoseTrackerOptions{.marker_length = wanted.marker_length, .ids = wanted.ids},
        camera_);
    tracked_ = wanted;
  }
  Solved solved;
  std::vector<tracking::DetectedMarker> detected;
  std::map<int, int> of_id;
  for (const protocol::MarkerCorners& wire : corners) {
    if (++of_id[wire.marker()] > protocol::kMaxSameMarker) continue;
    if (const auto marker = marker_from(wire, camera_)) {
      detected.push_back(*marker);
    } else {
      solved.rejected.push_back(wire.marker());
    }
  }
  solved.poses = tracker_->track(detected);
  if (smoother_) solved.poses = smoother_->smooth(std::move(solved.poses), captured);
  return solved;
}

}  // namespace amalgam::net
