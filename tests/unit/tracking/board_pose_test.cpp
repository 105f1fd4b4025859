// Poses of boards: closed forms, noise, and markers that lie.
#include "tracking/board_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "client/synthetic/synthetic_path.h"
#include "tracking/board_tracker.h"

namespace amalgam::tracking {
namespace {

using client::look_at;

std::vector<SeenBoardMarker> see(const MarkerBoard& board, const common::MarkerPose& pose,
                                 const common::CameraModel& camera) {
  std::vector<SeenBoardMarker> seen;
  for (const BoardMarker& marker : board.markers) {
    SeenBoardMarker view{&marker, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec4 corner(marker.corners[i], 1.0);
      view.corners[i] =
          common::project(camera, glm::dvec3(common::to_matrix(pose) * corner)).value();
    }
    seen.push_back(view);
  }
  return seen;
}

common::CameraModel distorting_camera() {
  common::CameraModel camera = common::default_camera(800, 600);
  camera.distortion = {0.0995485, -0.206384, 0.00754589, 0.00336531};
  return camera;
}

void expect_pose(const BoardFit& fit, const common::MarkerPose& truth, double radians,
                 double metres) {
  ASSERT_FALSE(fit.solutions.empty());
  EXPECT_LT(angle_between(fit.solutions[0].pose.rotation, truth.rotation), radians);
  EXPECT_LT(glm::distance(fit.solutions[0].pose.translation, truth.translation), metres);
}

TEST(BoardPose, FindsAnExactPoseThroughADistortingLens) {
  const common::CameraModel camera = distorting_camera();
  const MarkerBoard board = make_grid_board(5, 7, 0.04, 0.01, 0);
  const auto truth = look_at({0.12, -0.4, 0.45}, {0.0, 0.0, 0.0}, 0);
  const BoardFit fit = solve_board(see(board, truth, camera), camera);
  expect_pose(fit, truth, 1e-6, 1e-6);
  EXPECT_LT(fit.solutions[0].error, 1e-4);
  EXPECT_TRUE(fit.outliers.empty());
}

TEST(BoardPose, ABoardThatIsNotFlat) {
  const common::CameraModel camera = common::default_camera(800, 600);
  MarkerBoard corner;  // of a box: three faces that meet
  const glm::dmat4 one(1.0);
  corner.markers.push_back(square_marker(0, 0.06, glm::translate(one, glm::dvec3(0, 0, 0.05))));
  corner.markers.push_back(square_marker(1, 0.06,
                                         glm::rotate(glm::translate(one, glm::dvec3(0.05, 0, 0)),
                                                     glm::radians(90.0), glm::dvec3(0, 1, 0))));
  corner.markers.push_back(square_marker(2, 0.06,
                                         glm::rotate(glm::translate(one, glm::dvec3(0, -0.05, 0)),
                                                     glm::radians(90.0), glm::dvec3(1, 0, 0))));
  const auto truth = look_at({0.3, -0.3, 0.3}, {0.0, 0.0, 0.0}, 0);
  expect_pose(solve_board(see(corner, truth, camera), camera), truth, 1e-5, 1e-5);
}

TEST(BoardPose, ABoardThatFacesTheCameraExactly) {
  const common::CameraModel camera = common::default_camera(801, 601);
  common::MarkerPose facing;
  facing.rotation = glm::dquat(0.0, 1.0, 0.0, 0.0);
  facing.translation = {0.0, 0.0, 0.5};
  const MarkerBoard board = make_grid_board(3, 3, 0.04, 0.01, 0);
  expect_pose(solve_board(see(board, facing, camera), camera), facing, 0.01, 1e-4);
}

struct Rms {
  double degrees = 0.0, millimetres = 0.0;
};

// Half a pixel of noise on each corner's coordinates.
Rms noise_errors(const MarkerBoard& board, int draws) {
  const common::CameraModel camera = common::default_camera(800, 600);
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, 0.5);
  std::uniform_real_distribution<double> turn(0.0, 6.283), distance(0.4, 0.8);
  Rms rms;
  for (int draw = 0; draw < draws; ++draw) {
    const double a = turn(random), d = distance(random);
    const auto truth = look_at(d * glm::dvec3(0.6 * std::cos(a), 0.6 * std::sin(a), 0.8), {}, 0);
    auto seen = see(board, truth, camera);
    for (auto& marker : seen) {
      for (glm::dvec2& corner : marker.corners) corner += glm::dvec2(noise(random), noise(random));
    }
    const BoardFit fit = solve_board(seen, camera);
    EXPECT_FALSE(fit.solutions.empty());
    if (fit.solutions.empty()) continue;
    // The better of the two: which one is taken is for PoseDisambiguation and not in question here.
    double degrees = 180.0, millimetres = 0.0;
    for (const PoseSolution& solution : fit.solutions) {
      const double off = glm::degrees(angle_between(solution.pose.rotation, truth.rotation));
      if (off >= degrees) continue;
      degrees = off;
      millimetres = 1e3 * glm::distance(solution.pose.translation, truth.translation);
    }
    rms.degrees += degrees * degrees / draws;
    rms.millimetres += millimetres * millimetres / draws;
  }
  return {std::sqrt(rms.degrees), std::sqrt(rms.millimetres)};
}

TEST(BoardPose, IsBetterThanASingleMarkers) {
  const Rms one = noise_errors(make_grid_board(1, 1, 0.04, 0.01, 0), 300);
  const Rms four = noise_errors(make_grid_board(2, 2, 0.04, 0.01, 0), 300);
  const Rms all = noise_errors(make_grid_board(5, 7, 0.04, 0.01, 0), 300);
  std::printf(
      "rms error at 0.4 to 0.8 m, corners 0.5 pixel off: one marker %.2f degrees %.2f mm, "
      "2x2 %.3f degrees %.2f mm, 5x7 %.3f degrees %.2f mm\n",
      one.degrees, one.millimetres, four.degrees, four.millimetres, all.degrees, all.millimetres);
  // Wider by w and with n times the points, the error along the line of sight falls by w sqrt(n):
  // 2.25 * 2 for four markers, more than 6 * 5.9 for all (tilt by more); a third of that is asked.
  EXPECT_LT(four.degrees, one.degrees / 2);
  EXPECT_LT(four.millimetres, one.millimetres / 2);
  EXPECT_LT(all.degrees, one.degrees / 10);
  EXPECT_LT(all.millimetres, one.millimetres / 10);
}

class WrongMarker : public testing::TestWithParam<int> {};

TEST_P(WrongMarker, IsLeftOut) {
  const common::CameraModel camera = distorting_camera();
  const MarkerBoard board = make_grid_board(GetParam(), 1, 0.04, 0.01, 0);
  const auto truth = look_at({0.1, -0.35, 0.4}, {}, 0);
  for (std::size_t wrong = 0; wrong < board.markers.size(); ++wrong) {
    auto seen = see(board, truth, camera);
    for (glm::dvec2& corner : seen[wrong].corners) corner += glm::dvec2(35, -20);
    const BoardFit fit = solve_board(seen, camera);
    EXPECT_EQ(fit.outliers, std::vector{board.markers[wrong].id});
    expect_pose(fit, truth, 1e-5, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(AmongOthers, WrongMarker, testing::Values(3, 4, 6));

TEST(BoardPose, SeveralWrongMarkersAmongMany) {
  const common::CameraModel camera = distorting_camera();
  const MarkerBoard board = make_grid_board(5, 7, 0.04, 0.01, 0);
  const auto truth = look_at({0.1, -0.4, 0.5}, {}, 0);
  auto seen = see(board, truth, camera);
  std::ranges::rotate(seen[3].corners, seen[3].corners.begin() + 1);  // misread by a quarter turn
  for (glm::dvec2& corner : seen[20].corners) corner += glm::dvec2(60, 40);
  for (glm::dvec2& corner : seen[31].corners) corner -= glm::dvec2(90, 0);
  BoardFit fit = solve_board(seen, camera);
  std::ranges::sort(fit.outliers);
  EXPECT_EQ(fit.outliers, (std::vector{3, 20, 31}));
  expect_pose(fit, truth, 1e-5, 1e-5);
}

TEST(BoardPose, TwoThatContradictEachOtherGiveNone) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const MarkerBoard board = make_grid_board(2, 1, 0.04, 0.01, 0);
  auto seen = see(board, look_at({0.1, -0.35, 0.4}, {}, 0), camera);
  for (glm::dvec2& corner : seen[1].corners) corner += glm::dvec2(200, -150);
  EXPECT_TRUE(solve_board(seen, camera).solutions.empty());
}

TEST(BoardPose, NonsenseGivesNothingOrSomethingUsable) {
  const common::CameraModel camera = common::default_camera(640, 480);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MarkerBoard board = make_grid_board(2, 2, 0.04, 0.01, 0);
  EXPECT_TRUE(solve_board({}, camera).solutions.empty());
  for (const SquareCorners& corners : {SquareCorners{{{10, 10}, {10, 10}, {10, 10}, {10, 10}}},
                                       SquareCorners{{{10, 10}, {20, 10}, {30, 10}, {40, 10}}},
                                       SquareCorners{{{nan, 10}, {20, 10}, {20, 20}, {10, 20}}},
                                       SquareCorners{{{10, 10}, {20, 20}, {20, 10}, {10, 20}}}}) {
    std::vector<SeenBoardMarker> seen;
    for (const BoardMarker& marker : board.markers) seen.push_back({&marker, corners});
    for (const PoseSolution& solution : solve_board(seen, camera).solutions) {
      EXPECT_TRUE(common::is_usable(solution.pose));
    }
  }
}

// What a camera sees of the markers whose ids are in [first, last].
std::vector<DetectedMarker> seen_of(const std::vector<BoardMarker>& markers,
                                    const common::MarkerPose& pose,
                                    const common::CameraModel& camera, int first, int last) {
  std::vector<DetectedMarker> seen;
  for (const BoardMarker& marker : markers) {
    if (marker.id < first || marker.id > last) continue;
    DetectedMarker& detected = seen.emplace_back();
    detected.id = marker.id;
    for (std::size_t i = 0; i < 4; ++i) {
      detected.corners[i] = *common::project(
          camera, glm::dvec3(common::to_matrix(pose) * glm::dvec4(marker.corners[i], 1.0)));
    }
  }
  return seen;
}

// Boards with an even number of rows were printed otherwise before OpenCV 4.6.
TEST(CharucoBoard, ShowsWhichLayoutWasPrinted) {
  const common::CameraModel camera = common::default_camera(640, 480);
  // Turned by 160 degrees about x: the board faces the camera, a little askew.
  const common::MarkerPose truth{
      0, glm::angleAxis(glm::radians(160.0), glm::dvec3(1, 0, 0)), {0.01, -0.02, 0.4}};
  const MarkerBoard board = make_charuco_board(4, 4, 0.05, 0.03, 0);
  for (const bool older : {false, true}) {
    const auto& printed = older ? board.older_markers : board.markers;
    BoardTracker tracker(board, camera);
    // A marker, or the top row, fits both layouts, in two places.
    EXPECT_FALSE(tracker.track(seen_of(printed, truth, camera, 0, 0), 0).pose);
    EXPECT_FALSE(tracker.track(seen_of(printed, truth, camera, 0, 1), 1).pose);
    const auto tracked = tracker.track(seen_of(printed, truth, camera, 0, 7), 2);
    ASSERT_TRUE(tracked.pose);
    EXPECT_LT(glm::distance(tracked.pose->translation, truth.translation), 1e-4);
    EXPECT_EQ(tracked.outliers, 0u);
    const auto row = tracker.track(seen_of(printed, truth, camera, 0, 1), 3);
    ASSERT_TRUE(row.pose);
    EXPECT_LT(glm::distance(row.pose->translation, truth.translation), 1e-3);
  }
}

TEST(CharucoBoard, HasOneLayoutWithAnOddNumberOfRows) {
  EXPECT_TRUE(make_charuco_board(4, 3, 0.05, 0.03, 0).older_markers.empty());
}

}  // namespace
}  // namespace amalgam::tracking
