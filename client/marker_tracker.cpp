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

cv::Mat to_grey(const cv::Mat& image, cv::ColorConversionCodes from_colour) {
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throw std::invalid_argument("markers are sought in 8-bit images of 1 or 3 channels");
  }
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, from_colour);
  return grey;
}

double area(const SquareCorners& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

struct Candidate {
  const DetectedMarker* marker = nullptr;
  std::vector<SquareSolution> solutions;
};

// Among markers of one id: the one nearest to where it was, or the largest if that is not known.
const Candidate& pick(const std::vector<Candidate>& candidates,
                      const std::optional<core::MarkerPose>& previous) {
  return *std::ranges::min_element(candidates, {}, [&](const Candidate& candidate) {
    if (!previous) return -area(candidate.marker->corners);
    return glm::distance(previous->translation, candidate.solutions[0].pose.translation);
  });
}

}  // namespace

MarkerTracker::MarkerTracker(const TrackerOptions& options, const core::CameraModel& camera)
    : options_(options),
      camera_(camera),
      dictionary_(find_dictionary(options.dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()) {
  if (!(options.marker_length > 0) || !std::isfinite(options.marker_length)) {
    throw std::runtime_error("the marker length must be positive");
  }
  if (const std::string defect = core::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("markers cannot be tracked: " + defect);
  }
}

std::vector<DetectedMarker> MarkerTracker::detect(const cv::Mat& image) const {
  return detect_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<core::MarkerPose> MarkerTracker::track(const cv::Mat& image) {
  return track_grey(to_grey(image, cv::COLOR_BGR2GRAY));
}

std::vector<core::MarkerPose> MarkerTracker::track(const core::ImageRgb8& image) {
  // cv::Mat has no view of constant pixels; to_grey() only reads them.
  auto* pixels = const_cast<core::Rgb8*>(image.data());
  const cv::Mat view(image.height(), image.width(), CV_8UC3, pixels);
  return track_grey(to_grey(view, cv::COLOR_RGB2GRAY));
}

std::vector<DetectedMarker> MarkerTracker::detect_grey(const cv::Mat& grey) const {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary_, corners, ids, parameters_);
  std::vector<DetectedMarker> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto& wanted = options_.ids;
    if (!wanted.empty() && std::ranges::find(wanted, ids[i]) == wanted.end()) continue;
    DetectedMarker marker{.id = ids[i], .corners = {}};
    for (std::size_t c = 0; c < 4; ++c) marker.corners[c] = {corners[i][c].x, corners[i][c].y};
    if (options_.refine_corners) {
      marker.corners = refine_corners(grey, dictionary_->markerSize, marker.corners);
    }
    found.push_back(marker);
  }
  return found;
}

std::vector<core::MarkerPose> MarkerTracker::track_grey(const cv::Mat& grey) {
  if (grey.cols != camera_.width || grey.rows != camera_.height) {
    throw std::invalid_argument("the image has another size than the camera");
  }
  const std::uint64_t frame = ++counts_.images;
  const std::vector<DetectedMarker> detected = detect_grey(grey);
  std::map<int, std::vector<Candidate>> candidates;
  for (const DetectedMarker& marker : detected) {
    auto solutions = solve_square(marker.corners, options_.marker_length, camera_);
    if (solutions.empty()) {
      ++counts_.unsolved;
    } else {
      candidates[marker.id].push_back({&marker, std::move(solutions)});
    }
  }
  std::vector<core::MarkerPose> poses;
  for (const auto& [id, of_id] : candidates) {
    counts_.repeated += of_id.size() - 1;
    PoseMemory& memory = memories_[id];
    const Candidate& chosen = pick(of_id, memory.previous(frame));
    if (auto pose = memory.choose(chosen.solutions, frame)) {
      pose->marker = id;
      poses.push_back(*pose);
    }
  }
  counts_.poses += poses.size();
  return poses;
}

}  // namespace amalgam::client
