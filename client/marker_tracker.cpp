#include "client/marker_tracker.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "client/edge_refinement.h"
#include "client/marker_dictionary.h"

namespace amalgam::client {
namespace {

cv::Mat to_grey(const cv::Mat& image, cv::ColorConversionCodes from_color) {
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throw std::invalid_argument("markers are sought in 8-bit images of 1 or 3 channels");
  }
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, from_color);
  return grey;
}

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

MarkerTracker::MarkerTracker(const TrackerOptions& options, const common::CameraModel& camera)
    : options_(options),
      camera_(camera),
      dictionary_(find_dictionary(options.dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()) {
  if (!(options.marker_length > 0) || !std::isfinite(options.marker_length)) {
    throw std::runtime_error("the marker length must be positive");
  }
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("markers cannot be tracked: " + defect);
  }
  if (options.board) board_.emplace(placed_on(*options.board, options.world_marker), camera);
}

std::vector<DetectedMarker> MarkerTracker::detect(const cv::Mat& image) const {
  return detect_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<common::MarkerPose> MarkerTracker::track(const cv::Mat& image) {
  return track_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<common::MarkerPose> MarkerTracker::track(const common::ImageRgb8& image) {
  // cv::Mat has no view of constant pixels; to_grey() only reads them.
  auto* pixels = const_cast<common::Rgb8*>(image.data());
  const cv::Mat view(image.height(), image.width(), CV_8UC3, pixels);
  return track_grey(to_grey(view, cv::COLOR_RGB2GRAY));
}

std::vector<DetectedMarker> MarkerTracker::detect_grey(const cv::Mat& grey) const {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary_, corners, ids, parameters_);
  std::vector<DetectedMarker> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool on_board = board_ && board_->board().find(ids[i]) != nullptr;
    if (!is_of_interest(ids[i]) && !on_board) continue;
    DetectedMarker marker{.id = ids[i], .corners = {}};
    for (std::size_t c = 0; c < 4; ++c) marker.corners[c] = {corners[i][c].x, corners[i][c].y};
    if (options_.refine_corners) {
      marker.corners = refine_corners(grey, dictionary_->markerSize, marker.corners);
    }
    found.push_back(marker);
  }
  return found;
}

bool MarkerTracker::is_of_interest(int id) const {
  return options_.ids.empty() || std::ranges::find(options_.ids, id) != options_.ids.end();
}

std::vector<common::MarkerPose> MarkerTracker::track_grey(const cv::Mat& grey) {
  if (grey.cols != camera_.width || grey.rows != camera_.height) {
    throw std::invalid_argument("the image has another size than the camera");
  }
  ++counts_.images;
  const std::vector<DetectedMarker> detected = detect_grey(grey);
  std::map<int, common::MarkerPose> of_id = single_poses(detected);
  if (board_) add_board_poses(detected, of_id);
  std::vector<common::MarkerPose> poses;
  for (const auto& [id, pose] : of_id) {
    poses.push_back(pose);
    poses.back().marker = id;
  }
  counts_.poses += poses.size();
  return poses;
}

std::map<int, common::MarkerPose> MarkerTracker::single_poses(
    const std::vector<DetectedMarker>& detected) {
  std::map<int, std::vector<Candidate>> candidates;
  for (const DetectedMarker& marker : detected) {
    // A board's markers may have another length, and are not asked one by one.
    if (board_ && board_->board().find(marker.id) != nullptr) continue;
    auto solutions = solve_square(marker.corners, options_.marker_length, camera_);
    if (solutions.empty()) {
      ++counts_.unsolved;
    } else {
      candidates[marker.id].push_back({&marker, std::move(solutions)});
    }
  }
  std::map<int, common::MarkerPose> poses;
  for (const auto& [id, of_id] : candidates) {
    counts_.repeated += of_id.size() - 1;
    PoseDisambiguation& memory = memories_[id];
    const Candidate& chosen = pick(of_id, memory.previous(counts_.images));
    if (const auto pose = memory.choose(chosen.solutions, counts_.images)) poses[id] = *pose;
  }
  return poses;
}

void MarkerTracker::add_board_poses(const std::vector<DetectedMarker>& detected,
                                    std::map<int, common::MarkerPose>& poses) {
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

}  // namespace amalgam::client
