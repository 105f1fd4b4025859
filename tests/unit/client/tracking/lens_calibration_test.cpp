// Views of a board that a known lens gives: the lens must come back, and sets that do not determine
// it must be refused.
#include "client/tracking/lens_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <stdexcept>

#include "client/tracking/board_description.h"
#include "client/tracking/calibration.h"

namespace amalgam::client {
namespace {

using testing::HasSubstr;
using Offer = LensCalibration::Offer;

const cv::Size kSize{640, 480};

common::CameraModel known_lens() {
  common::CameraModel camera = common::camera_of_view(kSize.width, kSize.height, 65.0);
  camera.fy = 1.01 * camera.fx;
  camera.cx += 6.0;
  camera.cy -= 4.0;
  camera.distortion[0] = -0.12;
  camera.distortion[1] = 0.05;
  camera.distortion[2] = 0.001;
  return camera;
}

const tracking::MarkerBoard& board() {
  static const auto the_board = parse_charuco_board("5x7:0.035:0.026");
  return the_board;
}

// Of the board's markers that lie in the picture; noise in pixels (standard deviation).
std::vector<tracking::DetectedMarker> view(const glm::dvec3& tilt, const glm::dvec3& position,
                                           std::mt19937_64& random, double noise = 0.05) {
  const common::CameraModel camera = known_lens();
  const glm::dquat turn = glm::dquat(tilt) * glm::dquat(0.0, 1.0, 0.0, 0.0);
  std::normal_distribution<double> jitter(0.0, noise);
  std::vector<tracking::DetectedMarker> seen;
  for (const tracking::BoardMarker& marker : board().markers) {
    tracking::DetectedMarker found{.id = marker.id, .corners = {}};
    bool inside = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto pixel = common::project(camera, turn * marker.corners[i] + position);
      inside = inside && pixel && pixel->x > 0 && pixel->y > 0 && pixel->x < kSize.width - 1 &&
               pixel->y < kSize.height - 1;
      if (inside) found.corners[i] = *pixel + glm::dvec2(jitter(random), jitter(random));
    }
    if (inside) seen.push_back(found);
  }
  return seen;
}

// Held about as people do: into all corners, turned both ways.
void offer_good_views(LensCalibration& lens, double noise = 0.05) {
  std::mt19937_64 random(7);
  int i = 0;
  for (const double x : {-0.1, 0.0, 0.1}) {
    for (const double y : {-0.06, 0.0, 0.06}) {
      for (const double z : {0.28, 0.36}) {
        const double a = 0.35 * ((i % 3) - 1), b = 0.4 * ((i / 2 % 3) - 1);
        lens.offer(view({a, b, 0.1 * i}, {x, y, z}, random, noise));
        ++i;
      }
    }
  }
}

std::string refusal(const LensCalibration& lens) {
  try {
    lens.solve();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LensCalibration, FindsTheLens) {
  LensCalibration lens(board(), kSize);
  offer_good_views(lens);
  EXPECT_GE(lens.views(), 15u);
  EXPECT_GE(lens.coverage(), 0.9);
  const LensCalibration::Result result = lens.solve();
  const common::CameraModel truth = known_lens();
  // 0.05 pixels of noise on some thousand corners.
  EXPECT_NEAR(result.error, 0.05 * std::sqrt(2.0), 0.01);
  EXPECT_NEAR(result.camera.fx, truth.fx, 0.002 * truth.fx);
  EXPECT_NEAR(result.camera.fy, truth.fy, 0.002 * truth.fy);
  EXPECT_NEAR(result.camera.cx, truth.cx, 1.0);
  EXPECT_NEAR(result.camera.cy, truth.cy, 1.0);
  EXPECT_NEAR(result.camera.distortion[0], truth.distortion[0], 0.01);
}

TEST(LensCalibration, WritesWhatTheClientReads) {
  LensCalibration lens(board(), kSize);
  offer_good_views(lens);
  const LensCalibration::Result result = lens.solve();
  const auto file =
      std::filesystem::path(testing::TempDir()) / ("lens_" + std::to_string(getpid()) + ".yml");
  write_calibration(file, result);
  EXPECT_EQ(load_calibration(file), result.camera);
  std::filesystem::remove(file);
}

TEST(LensCalibration, ViewsLikeAnotherAreNotTaken) {
  LensCalibration lens(board(), kSize);
  std::mt19937_64 random(1);
  EXPECT_EQ(lens.offer(view({}, {0, 0, 0.35}, random)), Offer::Taken);
  EXPECT_EQ(lens.offer(view({}, {0.002, 0, 0.35}, random)), Offer::LikeAnother);
  EXPECT_EQ(lens.offer(view({}, {0.03, 0, 0.35}, random)), Offer::Taken);
  EXPECT_EQ(lens.offer({}), Offer::TooFewMarkers);
  EXPECT_EQ(lens.views(), 2u);
}

TEST(LensCalibration, RefusesSetsThatDoNotDetermineTheLens) {
  std::mt19937_64 random(2);
  LensCalibration few(board(), kSize);
  few.offer(view({}, {0, 0, 0.35}, random));
  EXPECT_THAT(refusal(few), HasSubstr("1 different views"));

  LensCalibration middle(board(), kSize);
  for (int i = 0; i < 12; ++i) {
    const double x = 0.04 * (i % 3 - 1), y = 0.04 * (i / 3 - 1.5);
    middle.offer(view({0.3, 0.0, 1.1 * i}, {x, y, 1.0}, random));
  }
  EXPECT_THAT(refusal(middle), HasSubstr("% of the picture"));

  // Without a tilt, focal length and distance cannot be told apart.
  LensCalibration frontal(board(), kSize);
  for (const double x : {-0.08, 0.0, 0.08}) {
    for (const double y : {-0.06, 0.0, 0.06}) frontal.offer(view({}, {x, y, 0.3}, random, 0.0));
  }
  EXPECT_THAT(refusal(frontal), HasSubstr("alike"));

  LensCalibration blurred(board(), kSize);
  offer_good_views(blurred, 3.0);
  EXPECT_THAT(refusal(blurred), HasSubstr("contradict"));
}

TEST(LensCalibration, RefusesBoardsThatAreNotKnownOrNotFlat) {
  EXPECT_THROW(LensCalibration(parse_charuco_board("5x6:0.035:0.026"), kSize), std::runtime_error);
  tracking::MarkerBoard bent = board();
  bent.markers[0].corners[0].z = 0.01;
  EXPECT_THROW(LensCalibration(bent, kSize), std::runtime_error);
}

}  // namespace
}  // namespace amalgam::client
