// Boards and several markers in images: drawn ones with known poses, and photographs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <opencv2/imgcodecs.hpp>

#include "client/synthetic/synthetic_path.h"
#include "client/tracking/board_description.h"
#include "client/tracking/calibration.h"
#include "client/tracking/marker_tracker.h"
#include "support/test_data.h"
#include "unit/client/tracking/printed_sheet.h"

namespace amalgam::client {
namespace {

std::optional<common::MarkerPose> pose_of_marker(const std::vector<common::MarkerPose>& poses,
                                                 int id) {
  const auto found = std::ranges::find(poses, id, &common::MarkerPose::marker);
  return found == poses.end() ? std::nullopt : std::optional(*found);
}

struct Errors {
  double degrees = 0.0, millimetres = 0.0;
};

Errors errors_of(const common::MarkerPose& pose, const common::MarkerPose& truth) {
  return {glm::degrees(tracking::angle_between(pose.rotation, truth.rotation)),
          1e3 * glm::distance(pose.translation, truth.translation)};
}

TEST(BoardTracking, PosesOfTheBoardAreBetterThanThoseOfTheWorldMarkerAlone) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const tracking::MarkerBoard grid =
      tracking::make_grid_board(4, 3, 0.04, 0.01, 37);  // 40 ends its first row
  const tracking::MarkerBoard board = placed_on(grid, 40);
  MarkerTracker single({.marker_length = 0.04, .ids = {40}}, camera);
  MarkerTracker whole({.marker_length = 0.04, .ids = {40}, .board = grid, .world_marker = 40},
                      camera);
  Errors single_sum, board_sum;
  constexpr int kFrames = 10;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double a = 0.6 * frame;
    const auto truth = look_at({-0.07 + 0.25 * std::cos(a), -0.2 + 0.2 * std::sin(a), 0.35},
                               {-0.07, -0.05, 0.0}, 40);
    const cv::Mat image = photograph(camera, prints_of(board, truth));
    const auto alone = single.track(image), together = whole.track(image);
    ASSERT_EQ(alone.size(), 1u);
    ASSERT_EQ(together.size(), 1u);
    EXPECT_EQ(together[0].marker, 40);
    const Errors of_single = errors_of(alone[0], truth), of_board = errors_of(together[0], truth);
    single_sum.degrees += of_single.degrees / kFrames;
    single_sum.millimetres += of_single.millimetres / kFrames;
    board_sum.degrees += of_board.degrees / kFrames;
    board_sum.millimetres += of_board.millimetres / kFrames;
  }
  std::printf(
      "mean error in images: one marker %.3f degrees %.3f mm, 4x3 board %.3f degrees %.3f "
      "mm\n",
      single_sum.degrees, single_sum.millimetres, board_sum.degrees, board_sum.millimetres);
  EXPECT_LT(board_sum.degrees, 0.5 * single_sum.degrees);
  EXPECT_LT(board_sum.millimetres, 0.5 * single_sum.millimetres);
  EXPECT_EQ(whole.counts().board_poses, std::uint64_t{kFrames});
  EXPECT_EQ(whole.counts().board_outliers, 0u);
}

TEST(BoardTracking, TheWorldMarkerNeedNotBeSeen) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const tracking::MarkerBoard board =
      placed_on(tracking::make_grid_board(3, 2, 0.04, 0.01, 40), 40);
  const auto truth = look_at({0.1, -0.3, 0.35}, {0.05, -0.02, 0.0}, 40);
  auto prints = prints_of(board, truth);
  std::erase_if(prints, [](const Print& print) { return print.id == 40 || print.id == 43; });
  MarkerTracker tracker({.ids = {40, 43, 9}, .board = board, .world_marker = 40}, camera);
  const auto poses = tracker.track(photograph(camera, prints));
  // Another marker of the board that carries something has its pose too.
  ASSERT_EQ(poses.size(), 2u);
  const Errors world = errors_of(pose_of_marker(poses, 40).value(), truth);
  EXPECT_LT(world.degrees, 0.3);
  EXPECT_LT(world.millimetres, 0.5);
  const auto below = pose_of_marker(poses, 43).value();
  const glm::dvec3 expected(common::to_matrix(truth) * glm::dvec4(0, -0.05, 0, 1));
  EXPECT_LT(glm::distance(below.translation, expected), 0.5e-3);
}

TEST(BoardTracking, AWorldMarkerThatIsNotOnTheBoardStandsInItsMiddle) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const tracking::MarkerBoard board = tracking::make_charuco_board(4, 3, 0.05, 0.035, 100);
  const auto truth = look_at({0.1, -0.3, 0.35}, {0.0, 0.0, 0.0}, 40);
  MarkerTracker tracker({.ids = {40}, .board = board, .world_marker = 40}, camera);
  const auto poses = tracker.track(photograph(camera, prints_of(board, truth)));
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].marker, 40);
  EXPECT_LT(errors_of(poses[0], truth).degrees, 0.3);
  EXPECT_LT(errors_of(poses[0], truth).millimetres, 0.5);
  // Without any marker of the board the world marker's own pose is the next best.
  const Print own{40, 0.05, common::to_matrix(truth)};
  EXPECT_EQ(tracker.track(photograph(camera, {own})).size(), 1u);
  EXPECT_TRUE(tracker.track(photograph(camera, {})).empty());
}

TEST(MarkerTracker, MarkersMoveEachOnItsOwn) {
  const common::CameraModel camera = common::default_camera(800, 600);
  MarkerTracker tracker({.ids = {40, 23, 7}}, camera);
  const auto world = look_at({0.0, -0.35, 0.35}, {0.0, 0.0, 0.0}, 40);
  for (int frame = 0; frame < 12; ++frame) {
    // 23 is carried around and turned, 7 comes and goes, 99 is none of our business.
    const double t = 0.08 * frame;
    const glm::dmat4 place =
        glm::translate(common::to_matrix(world), glm::dvec3(0.1, 0.05 * t, t / 9));
    const glm::dmat4 carried = glm::rotate(place, t, glm::normalize(glm::dvec3(1, 2, 5)));
    const glm::dmat4 aside = glm::translate(common::to_matrix(world), glm::dvec3(-0.1, 0.0, 0.0));
    const glm::dmat4 other = glm::translate(common::to_matrix(world), glm::dvec3(0.0, 0.1, 0.0));
    std::vector<Print> prints{
        {40, 0.05, common::to_matrix(world)}, {23, 0.05, carried}, {99, 0.05, other}};
    if (frame % 3 != 2) prints.push_back({7, 0.05, aside});
    const auto poses = tracker.track(photograph(camera, prints));
    ASSERT_EQ(poses.size(), frame % 3 != 2 ? 3u : 2u) << frame;
    common::MarkerPose truth;
    truth.rotation = glm::quat_cast(glm::dmat3(carried));
    truth.translation = glm::dvec3(carried[3]);
    const Errors of_carried = errors_of(pose_of_marker(poses, 23).value(), truth);
    EXPECT_LT(of_carried.degrees, 1.5) << frame;
    EXPECT_LT(of_carried.millimetres, 1.5) << frame;
    const Errors of_world = errors_of(pose_of_marker(poses, 40).value(), world);
    EXPECT_LT(of_world.degrees, 1.5) << frame;
    EXPECT_LT(of_world.millimetres, 1.5) << frame;
  }
}

TEST(MarkerTracker, OfARepeatedIdTheOneThatWasThereIsFollowed) {
  const common::CameraModel camera = common::default_camera(800, 600);
  MarkerTracker tracker({.ids = {40}}, camera);
  const auto first = look_at({0.08, -0.35, 0.35}, {0.0, 0.0, 0.0}, 40);
  const glm::dmat4 nearer = glm::translate(common::to_matrix(first), glm::dvec3(0.1, -0.08, 0.0));
  const Print own{40, 0.05, common::to_matrix(first)}, intruder{40, 0.05, nearer};
  tracker.track(photograph(camera, {own}));
  const auto poses = tracker.track(photograph(camera, {own, intruder}));
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_LT(glm::distance(poses[0].translation, first.translation), 0.002);
  EXPECT_EQ(tracker.counts().repeated, 1u);
  // Without a past it is the larger one.
  MarkerTracker fresh({.ids = {40}}, camera);
  const auto larger = fresh.track(photograph(camera, {own, intruder}));
  ASSERT_EQ(larger.size(), 1u);
  EXPECT_LT(glm::distance(larger[0].translation, glm::dvec3(nearer[3])), 0.002);
}

TEST(BoardTracking, ARepeatedMarkerOfTheBoardIsTheOneThatFits) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const tracking::MarkerBoard board =
      placed_on(tracking::make_grid_board(2, 1, 0.04, 0.01, 40), 40);
  const auto truth = look_at({0.05, -0.3, 0.35}, {0.0, 0.0, 0.0}, 40);
  MarkerTracker tracker({.ids = {40}, .board = board, .world_marker = 40}, camera);
  auto prints = prints_of(board, truth);
  tracker.track(photograph(camera, prints));
  prints.push_back(
      {41, 0.06, glm::translate(common::to_matrix(truth), glm::dvec3(0.0, -0.1, 0.0))});
  const auto poses = tracker.track(photograph(camera, prints));
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_LT(errors_of(poses[0], truth).millimetres, 0.7);
  EXPECT_EQ(tracker.counts().repeated, 1u);
}

struct BoardPhotograph {
  const char* image;
  const char* calibration;
  const char* dictionary;
  tracking::MarkerBoard board;
  double max_error;  // pixels, root mean square over the board
  double max_tilt;   // degrees, of single markers against the board, root mean square
};

// There is no true pose to compare with; but how well one pose explains all corners, and whether
// single markers scatter about it, can be measured. The cameras are similar to those that took the
// pictures and not the same (the first), and paper is not flat: hence the bounds.
void expect_consistent(const BoardPhotograph& photo) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "no test data (AMALGAM_TEST_DATA or ../shared/data)";
  const auto folder = *data / "real_markers" / "opencv_contrib";
  const cv::Mat image = cv::imread((folder / photo.image).string());
  ASSERT_FALSE(image.empty());
  const auto camera =
      fit_to_image(load_calibration(folder / photo.calibration), image.cols, image.rows);
  const std::string name = photo.dictionary;
  const std::string dictionary = name.ends_with(".yml") ? (folder / name).string() : name;
  MarkerTracker tracker(
      {.dictionary = dictionary, .ids = {999}, .board = photo.board, .world_marker = 999}, camera);
  const auto poses = tracker.track(image);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(tracker.counts().board_outliers, 0u);
  double sum = 0.0, tilt = 0.0;
  const auto detected = tracker.detect(image);
  EXPECT_EQ(detected.size(), photo.board.markers.size());
  for (const tracking::DetectedMarker& marker : detected) {
    const tracking::BoardMarker& known = *photo.board.find(marker.id);
    const double error = tracking::reprojection_error({&known, marker.corners}, poses[0], camera);
    sum += error * error;
    const double length = glm::distance(known.corners[0], known.corners[1]);
    const auto alone = tracking::solve_square(marker.corners, length, camera);
    ASSERT_FALSE(alone.empty());
    double off = 180.0;
    for (const tracking::PoseSolution& solution : alone) {
      off = std::min(
          off, glm::degrees(tracking::angle_between(solution.pose.rotation, poses[0].rotation)));
    }
    tilt += off * off;
  }
  const double count = static_cast<double>(detected.size());
  std::printf(
      "%s: %zu markers, corners off by %.2f pixels (rms), single markers' rotations by %.1f "
      "degrees (rms)\n",
      photo.image, detected.size(), std::sqrt(sum / count), std::sqrt(tilt / count));
  EXPECT_LT(std::sqrt(sum / count), photo.max_error);
  EXPECT_LT(std::sqrt(tilt / count), photo.max_tilt);
}

// The gap is a fifth of a marker, as can be measured in the picture.
TEST(BoardPhotographs, Grid) {
  expect_consistent({"gboriginal.png", "tutorial_camera_params.yml", "tutorial_dict.yml",
                     tracking::make_grid_board(5, 7, 0.1, 0.02, 0), 2.5, 3.5});
}

TEST(BoardPhotographs, Charuco) {
  expect_consistent({"choriginal.jpg", "tutorial_camera_charuco.yml", "DICT_6X6_250",
                     tracking::make_charuco_board(5, 7, 0.04, 0.02, 0), 1.0, 2.5});
}

}  // namespace
}  // namespace amalgam::client
