#include "tracking/pose_tracker.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace amalgam::tracking {
namespace {

struct Candidate {
  const DetectedMarker* marker = nullptr;
  std::vector<PoseSolution> solutions;
};

// Among markers of one id: the one nearest to where it was, or the largest if that is not known.
const Candidate& pick(const std::vector<Candidate>& candidates,
                      const std::optional<common::MarkerPose>& previous) {
  return *std::ranges::min_element(candidates, {}, [&](const Candidate& candidate) {
    if (!previous) return -area(candidate.marker->corners);
    return glm::distance(previous->translation, candidate.solutions[0].pose.translation);
  });
}

}  // namespace

TrackerCounts& TrackerCounts::operator+=(const TrackerCounts& other) {
  images += other.images;
  poses += other.poses;
  repeated += other.repeated;
  unsolved += other.unsolved;
  board_poses += other.board_poses;
  board_outliers += other.board_outliers;
  return *this;
}

PoseTracker::PoseTracker(const PoseTrackerOptions& options, const common::CameraModel& camera)
    : options_(options), camera_(camera) {
  if (!(options.marker_length > 0) || !std::isfinite(options.marker_length)) {
    throw std::runtime_error("the marker length must be positive");
  }
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("markers cannot be tracked: " + defect);
  }
  if (options.board) board_.emplace(placed_on(*options.board, options.world_marker), camera);
}

bool PoseTracker::is_of_interest(int id) const {
  return options_.ids.empty() || std::ranges::find(options_.ids, id) != options_.ids.end();
}

bool PoseTracker::is_on_board(int id) const {
  return board_ && board_->board().find(id) != nullptr;
}

std::vector<common::MarkerPose> PoseTracker::track(std::span<const DetectedMarker> detected) {
  ++counts_.images;
  PosesById of_id = single_poses(detected);
  if (board_) add_board_poses(detected, of_id);
  std::vector<common::MarkerPose> poses;
  for (const auto& [id, pose] : of_id) {
    poses.push_back(pose);
    poses.back().marker = id;
  }
  counts_.poses += poses.size();
  return poses;
}

PoseTracker::PosesById PoseTracker::single_poses(std::span<const DetectedMarker> detected) {
  std::map<int, std::vector<Candidate>> candidates;
  for (const DetectedMarker& marker : detected) {
    // A board's markers may have another length, and are not asked one by one.
    if (!is_of_interest(marker.id) || is_on_board(marker.id)) continue;
    auto solutions = solve_square(marker.corners, options_.marker_length, camera_);
    if (solutions.empty()) {
      ++counts_.unsolved;
    } else {
      candidates[marker.id].push_back({&marker, std::move(solutions)});
    }
  }
  PosesById poses;
  for (const auto& [id, of_id] : candidates) {
    counts_.repeated += of_id.size() - 1;
    PoseDisambiguation& memory = memories_[id];
    const Candidate& chosen = pick(of_id, memory.previous(counts_.images));
    if (const auto pose = memory.choose(chosen.solutions, counts_.images)) poses[id] = *pose;
  }
  return poses;
}

void PoseTracker::add_board_poses(std::span<const DetectedMarker> detected, PosesById& poses) {
  const BoardTracker::Tracked tracked = board_->track(detected, counts_.images);
  counts_.repeated += tracked.repeated;
  counts_.board_outliers += tracked.outliers;
  if (!tracked.pose) return;
  ++counts_.board_poses;
  for (const BoardMarker& marker : board_->board().markers) {
    if (is_of_interest(marker.id)) poses[marker.id] = pose_of(marker, *tracked.pose);
  }
  if (is_of_interest(options_.world_marker) && options_.world_marker >= 0) {
    poses[options_.world_marker] = *tracked.pose;
  }
}

}  // namespace amalgam::tracking
