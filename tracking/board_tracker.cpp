#include "tracking/board_tracker.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <stdexcept>
#include <utility>

#include "common/log.h"

namespace amalgam::tracking {

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
  if (!board_.older_markers.empty()) {
    choose_layout(markers);
    return board_.older_markers.empty() ? track(detected, frame) : tracked;
  }
  const BoardFit fit = solve_board(markers, camera_);
  tracked.outliers = fit.outliers.size();
  tracked.pose = memory_.choose(fit.solutions, frame);
  return tracked;
}

void BoardTracker::choose_layout(std::span<const SeenBoardMarker> seen) {
  const MarkerBoard older{board_.older_markers};
  std::vector<SeenBoardMarker> as_older;
  for (const SeenBoardMarker& marker : seen) {
    as_older.push_back({older.find(marker.marker->id), marker.corners});
  }
  const BoardFit newer_fit = solve_board(seen, camera_), older_fit = solve_board(as_older, camera_);
  const auto is_better = [](const BoardFit& a, const BoardFit& b) {
    constexpr double kClearly = 3.0;
    if (a.solutions.empty() || b.solutions.empty())
      return b.solutions.empty() && !a.solutions.empty();
    if (a.outliers.size() != b.outliers.size()) return a.outliers.size() < b.outliers.size();
    return kClearly * a.solutions.front().error < b.solutions.front().error;
  };
  if (is_better(older_fit, newer_fit)) {
    common::log_warn("the ChArUco board has the layout of OpenCV before 4.6, and is read as such");
    board_.markers = std::move(board_.older_markers);
    board_.older_markers.clear();
  } else if (is_better(newer_fit, older_fit)) {
    board_.older_markers.clear();
  }
}

common::MarkerPose pose_of(const BoardMarker& marker, const common::MarkerPose& camera_from_board) {
  const glm::dmat4 camera_from_marker = common::to_matrix(camera_from_board) * frame_of(marker);
  return {.marker = marker.id,
          .rotation = glm::normalize(glm::quat_cast(glm::dmat3(camera_from_marker))),
          .translation = glm::dvec3(camera_from_marker[3])};
}

}  // namespace amalgam::tracking
