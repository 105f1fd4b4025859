// Layouts of boards: against OpenCV's own generators, and as users write them.
#include "tracking/marker_board.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <opencv2/aruco.hpp>
#include <opencv2/aruco/charuco.hpp>

#include "client/tracking/board_description.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::tracking {
namespace {

using client::load_board;
using client::parse_charuco_board;
using client::parse_grid_board;

// OpenCV's origin and the direction of its axes have changed between versions; the distances
// between corners have not.
void expect_same_layout(const MarkerBoard& board, const cv::aruco::Board& theirs) {
  ASSERT_EQ(board.markers.size(), theirs.ids.size());
  const auto point = [](const cv::Point3f& p) { return glm::dvec3(p.x, p.y, p.z); };
  for (std::size_t i = 0; i < board.markers.size(); ++i) {
    EXPECT_EQ(board.markers[i].id, theirs.ids[i]);
    for (std::size_t c = 0; c < 4; ++c) {
      for (const std::size_t reference : {0u, 1u, 2u}) {
        const double ours =
            glm::distance(board.markers[i].corners[c], board.markers[0].corners[reference]);
        const double expected =
            glm::distance(point(theirs.objPoints[i][c]), point(theirs.objPoints[0][reference]));
        EXPECT_NEAR(ours, expected, 1e-6) << "marker " << i << " corner " << c;
      }
    }
  }
}

TEST(MarkerBoard, GridIsLaidOutAsOpenCvPrintsIt) {
  const auto theirs =
      cv::aruco::GridBoard::create(5, 7, 0.04f, 0.01f, find_dictionary("DICT_6X6_250"), 3);
  const MarkerBoard board = parse_grid_board("5x7:0.04:0.01:3");
  expect_same_layout(board, *theirs);
  // The second is right of the first, the sixth below it, all around the origin.
  const auto centre = [&](std::size_t i) { return glm::dvec3(frame_of(board.markers[i])[3]); };
  EXPECT_NEAR(centre(1).x - centre(0).x, 0.05, 1e-12);
  EXPECT_NEAR(centre(5).y - centre(0).y, -0.05, 1e-12);
  EXPECT_NEAR(glm::length(centre(17)), 0.0, 1e-12);
}

TEST(MarkerBoard, CharucoIsLaidOutAsOpenCvPrintsIt) {
  const auto theirs =
      cv::aruco::CharucoBoard::create(5, 7, 0.04f, 0.02f, find_dictionary("DICT_6X6_250"));
  expect_same_layout(parse_charuco_board("5x7:0.04:0.02"), *theirs);
}

TEST(MarkerBoard, IsPlacedOnTheWorldMarkerIfThatIsPartOfIt) {
  const MarkerBoard grid = make_grid_board(3, 2, 0.04, 0.01, 40);
  const MarkerBoard placed = placed_on(grid, 41);
  const glm::dmat4 frame = frame_of(*placed.find(41));
  EXPECT_LT(glm::length(glm::dvec3(frame[3])), 1e-12);
  EXPECT_NEAR(frame[0].x, 1.0, 1e-12);
  EXPECT_NEAR(frame[1].y, 1.0, 1e-12);
  EXPECT_NEAR(placed.find(42)->corners[0].x, 0.05 - 0.02, 1e-12);
  EXPECT_EQ(placed_on(grid, 7).markers[0].corners[0], grid.markers[0].corners[0]);
}

class BoardFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text, const std::string& ending = ".yml") {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const auto file =
        std::filesystem::path(testing::TempDir()) / ("board_" + std::string(test->name()) + ending);
    std::ofstream(file) << text;
    return file;
  }
  std::string defect_of(const std::string& text) {
    try {
      load_board(write(text));
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      EXPECT_EQ(what.find("board "), 0u) << what;
      return what;
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
  }
};

TEST_F(BoardFile, HoldsPlacedMarkersAndCorners) {
  const MarkerBoard board = load_board(write(R"(%YAML:1.0
---
marker_length: 0.05
markers:
  - { id: 40, position: [0, 0, 0] }
  - { id: 23, position: [0.2, 0, 0.1], rotation: [0, 0.70710678, 0, 0.70710678], length: 0.04 }
  - { id: 7, corners: [[0, 0.05, 0], [0.05, 0.05, 0], [0.05, 0, 0], [0, 0, 0]] }
)"));
  ASSERT_EQ(board.markers.size(), 3u);
  EXPECT_NEAR(board.markers[0].corners[1].x, 0.025, 1e-12);
  // A quarter turn about y: its right points along -z, its front along x.
  const glm::dmat4 turned = frame_of(board.markers[1]);
  EXPECT_NEAR(turned[0].z, -1.0, 1e-7);
  EXPECT_NEAR(turned[2].x, 1.0, 1e-7);
  EXPECT_NEAR(turned[3].x, 0.2, 1e-9);
  EXPECT_NEAR(glm::distance(board.markers[1].corners[0], board.markers[1].corners[1]), 0.04, 1e-9);
  EXPECT_NEAR(frame_of(board.markers[2])[3].x, 0.025, 1e-12);
}

TEST_F(BoardFile, MayBeJson) {
  const auto file = write(
      R"({"marker_length": 0.05, "markers": [{"id": 1, "position": [0, 0, 0]},
          {"id": 2, "position": [1, 0, 0]}]})",
      ".json");
  EXPECT_EQ(load_board(file).markers.size(), 2u);
}

TEST_F(BoardFile, SaysWhatIsWrong) {
  const std::string head = "%YAML:1.0\n---\nmarkers:\n";
  const auto has = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(defect_of(text).find(part), std::string::npos) << defect_of(text);
  };
  has("nonsense", "is not an OpenCV file");
  has("%YAML:1.0\n---\nother: 1\n", "no list of markers");
  has(head + "  - { position: [0, 0, 0], length: 1 }\n", "as id");
  has(head + "  - { id: 1, position: [0, 0, 0] }\n", "neither a length nor corners");
  has(head + "  - { id: 1, position: [0, 0], length: 1 }\n", "3 numbers");
  has(head + "  - { id: 1, position: [0, 0, .Nan], length: 1 }\n", "not within 100 m");
  has(head + "  - { id: 1, position: [0, 0, 0], length: 0 }\n", "no square");
  has(head + "  - { id: 1, position: [0, 0, 0], rotation: [0, 0, 0, 2], length: 1 }\n",
      "no unit quaternion");
  has(head +
          "  - { id: 1, position: [0, 0, 0], length: 1 }\n"
          "  - { id: 1, position: [2, 0, 0], length: 1 }\n",
      "there twice");
  has(head + "  - { id: 1, corners: [[0, 1, 0], [2, 1, 0], [2, 0, 0], [0, 0, 0]] }\n", "no square");
  EXPECT_THROW(load_board("no/such/board.yml"), std::runtime_error);
}

TEST(BoardText, RefusesWhatIsNoBoard) {
  for (const char* bad : {"", "5x7", "5x7:0.04", "0x7:0.04:0.01", "5x7:-1:0.01", "5x7:0.04:-0.01",
                          "5x7:nan:0.01", "5x7:inf:0.01", "5x7:0.04:0.01:x", "5x7:0.04:0.01:1:2",
                          "999x7:0.04:0.01", "5:0.04:0.01", "5x7:0.04:0.01:-3"}) {
    EXPECT_THROW(parse_grid_board(bad), std::runtime_error) << bad;
  }
  // The ids that follow the first one must be numbers too.
  try {
    parse_grid_board("5x7:0.04:0.01:2147483647");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("is not COLUMNSxROWS"), std::string::npos);
  }
  EXPECT_EQ(parse_grid_board("1x2:0.04:0:1000000").markers.back().id, 1'000'001);
  EXPECT_THROW(parse_charuco_board("5x7:0.02:0.04"), std::runtime_error);
  EXPECT_EQ(parse_grid_board("1x2:0.04:0").markers.size(), 2u);
}

}  // namespace
}  // namespace amalgam::tracking
