// Small markers side by side: a corner of one must not be caught by the edges of the other.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/synthetic/synthetic_path.h"
#include "client/tracking/calibration.h"
#include "client/tracking/marker_tracker.h"
#include "unit/client/tracking/printed_sheet.h"

namespace amalgam::client {
namespace {

constexpr double kLength = 0.02;

// A row of three markers; the gap is in bits of their pattern, an eighth of a side each.
std::vector<Print> row_of_markers(const common::MarkerPose& pose, double gap) {
  std::vector<Print> prints;
  for (int i = -1; i <= 1; ++i) {
    const glm::dvec3 at(i * kLength * (1.0 + gap / 8), 0.0, 0.0);
    prints.push_back(
        {i + 1, kLength, common::to_matrix(pose) * glm::translate(glm::dmat4(1), at), gap / 8 / 2});
  }
  return prints;
}

struct Errors {
  double corner = 0.0;    // largest distance of a found corner from the true one, pixels
  double distance = 0.0;  // largest error of a pose's distance, as a share of it
};

Errors measure(const common::CameraModel& camera, const std::vector<Print>& prints) {
  const cv::Mat image = photograph(camera, prints);
  MarkerTracker tracker({.marker_length = kLength}, camera);
  Errors errors;
  const auto found = tracker.detect(image);
  EXPECT_EQ(found.size(), prints.size());
  for (const tracking::DetectedMarker& marker : found) {
    const Print& print = prints.at(static_cast<std::size_t>(marker.id));
    const double half = kLength / 2;
    const std::array<glm::dvec2, 4> corners{
        {{-half, half}, {half, half}, {half, -half}, {-half, -half}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 corner(print.camera_from_marker * glm::dvec4(corners[i], 0, 1));
      errors.corner = std::max(
          errors.corner, glm::distance(marker.corners[i], common::project(camera, corner).value()));
    }
  }
  for (const common::MarkerPose& pose : tracker.track(image)) {
    const glm::dvec3 truth(prints.at(static_cast<std::size_t>(pose.marker)).camera_from_marker[3]);
    errors.distance =
        std::max(errors.distance, glm::distance(pose.translation, truth) / glm::length(truth));
  }
  return errors;
}

// At 0.4 m a marker is 25 pixels wide and one of its bits 3. A gap of one bit, the least that a
// marker's white margin should have, changes nothing. In half a bit the blur of both edges meets:
// corners lean towards the neighbour by fractions of a pixel, and never jump to it (the gap is 1.5
// pixels there).
TEST(NeighbouringMarkers, KeepTheirCorners) {
  const common::CameraModel camera = common::default_camera(640, 480);
  for (const auto& [gap, most_pixels, most_distance] :
       {std::tuple(2.0, 0.05, 0.001), {1.0, 0.2, 0.01}, {0.5, 0.5, 0.03}}) {
    Errors largest;
    for (const double distance : {0.2, 0.3, 0.4}) {
      const auto pose = look_at({0.1 * distance, -0.5 * distance, distance}, {0, 0, 0}, 0);
      const Errors errors = measure(camera, row_of_markers(pose, gap));
      largest.corner = std::max(largest.corner, errors.corner);
      largest.distance = std::max(largest.distance, errors.distance);
    }
    std::printf("gap of %.1f bits: corners off by %.3f pixels, positions by %.2f %%\n", gap,
                largest.corner, 100 * largest.distance);
    EXPECT_LT(largest.corner, most_pixels) << gap;
    EXPECT_LT(largest.distance, most_distance) << gap;
  }
}

}  // namespace
}  // namespace amalgam::client
