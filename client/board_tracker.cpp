#include "client/board_tracker.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <stdexcept>
#include <utility>

namespace amalgam::client {

BoardTracker::BoardTracker(MarkerBoard board, const common::CameraModel& camera)
    : board_(std::move(board)), camera_(camera) {
  const std::string defect = describe_defect(board_);
  if (!defect.empty()) throw std::runtime_error("the marker board " + defect);
}

BoardTracker::Tracked BoardTracker::track(std::span<const DetectedMarker> detected,
                                          std::uint64_t frame) {
  Tracked tracked;
  const auto last = memory_.previous(frame);
  // How unlikely a marker is to be the board's own.
  const auto badness = [&](const SeenBoardMarker& seen) {
    return last ? reprojection_error(seen, *last, camera_) : -area(seen.corners);
  };
  std::map<int, SeenBoardMarker> seen;
  for (const DetectedMarker& marker : detected) {
    const BoardMarker* known = board_.find(marker.id);
    if (known == nullptr) continue;
    const SeenBoardMarker candidate{known, marker.corners};
    const auto [entry, is_first] = seen.emplace(marker.id, candidate);
    if (is_first) continue;
    ++tracked.repeated;
    if (badness(candidate) < badness(entry->second)) entry->second = candidate;
  }
  std::vector<SeenBoardMarker> markers;
  for (const auto& [id, marker] : seen) markers.push_back(marker);
  const BoardFit fit = solve_board(markers, camera_);
  tracked.outliers = fit.outliers.size();
  tracked.pose = memory_.choose(fit.solutions, frame);
  return tracked;
}

common::MarkerPose pose_of(const BoardMarker& marker, const common::MarkerPose& camera_from_board) {
  const glm::dmat4 camera_from_marker = common::to_matrix(camera_from_board) * frame_of(marker);
  return {.marker = marker.id,
          .rotation = glm::normalize(glm::quat_cast(glm::dmat3(camera_from_marker))),
          .translation = glm::dvec3(camera_from_marker[3])};
}

}  // namespace amalgam::client
