// A printed page, looked at by the tracker: the markers are there and as large as they say.
#include "sheet/marker_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "client/tracking/board_description.h"
#include "client/tracking/marker_tracker.h"
#include "sheet/sheet_file.h"

namespace amalgam::sheet {
namespace {

constexpr double kPixelsPerMillimetre = 4.0;

// The page as a printer would draw it.
cv::Mat draw(const MarkerSheet& sheet) {
  const auto pixels = [](double mm) {
    return static_cast<int>(std::lround(mm * kPixelsPerMillimetre));
  };
  cv::Mat page(pixels(sheet.height), pixels(sheet.width), CV_8UC1, cv::Scalar(255));
  const auto fill = [&](const Square& square, int grey) {
    cv::rectangle(page, {pixels(square.x), pixels(square.y)},
                  {pixels(square.x + square.side) - 1, pixels(square.y + square.side) - 1},
                  cv::Scalar(grey), cv::FILLED);
  };
  for (const Square& square : sheet.pages.at(0).black) fill(square, 0);
  for (const SheetMarker& marker : sheet.pages.at(0).markers) {
    fill(marker.outline, 0);
    for (const Square& cell : marker.white) fill(cell, 255);
  }
  return page;
}

// Tag 0 of tag36h11 as the AprilTag project has it, by rows, is 0xd5d628584; OpenCV's dictionary
// has it turned by 180 degrees, that is, with its bits from the end (README, Scenes).
TEST(MarkerSheet, AprilTagsAreTurnedByHalf) {
  const MarkerSheet sheet =
      lay_out_markers({.dictionary = "DICT_APRILTAG_36h11", .ids = {0}, .length = 0.08});
  std::uint64_t bits = 0;
  for (const Square& cell : sheet.pages.at(0).markers.at(0).white) {
    const Square& outline = sheet.pages.at(0).markers[0].outline;
    const auto column = std::lround((cell.x - outline.x) / 10.0) - 1;
    const auto row = std::lround((cell.y - outline.y) / 10.0) - 1;
    bits |= std::uint64_t{1} << (6 * row + column);  // the first cell is the lowest bit
  }
  EXPECT_EQ(bits, 0xd5d628584u);
}

// A camera that looks straight down on the page from f pixels / (pixels per metre) away sees a
// marker of the right length at that distance.
TEST(MarkerSheet, IsFoundAtItsTrueSize) {
  const std::vector<int> ids{40, 7, 249};
  const MarkerSheet sheet =
      lay_out_markers({.dictionary = "DICT_6X6_250", .ids = ids, .length = 0.04});
  const cv::Mat page = draw(sheet);
  common::CameraModel camera = common::default_camera(page.cols, page.rows);
  client::MarkerTracker tracker({.marker_length = 0.04}, camera);
  const auto poses = tracker.track(page);
  ASSERT_EQ(poses.size(), ids.size());
  EXPECT_EQ(poses[0].marker, 7);
  EXPECT_EQ(poses[1].marker, 40);
  EXPECT_EQ(poses[2].marker, 249);
  const double distance = camera.fx / (1000.0 * kPixelsPerMillimetre);
  for (const auto& pose : poses) EXPECT_NEAR(pose.translation.z, distance, 0.005 * distance);
}

TEST(MarkerSheet, HasAWhiteMarginAndStaysOnThePage) {
  const MarkerSheet sheet =
      lay_out_markers({.dictionary = "DICT_4X4_50", .ids = {0, 1, 2, 3, 4}, .length = 0.05});
  for (const SheetMarker& marker : sheet.pages.at(0).markers) {
    EXPECT_GE(marker.outline.x, 10.0 + 2 * 50.0 / 6);
    EXPECT_LE(marker.outline.x + 50.0, 200.0 - 2 * 50.0 / 6);
    EXPECT_LE(marker.outline.y + 50.0, 277.0);
    for (const SheetMarker& other : sheet.pages.at(0).markers) {
      if (other.id == marker.id) continue;
      const bool apart = std::abs(other.outline.x - marker.outline.x) > 50.0 ||
                         std::abs(other.outline.y - marker.outline.y) > 50.0;
      EXPECT_TRUE(apart) << marker.id << " and " << other.id;
    }
  }
}

TEST(MarkerSheet, WhatCannotBePrintedIsSaid) {
  EXPECT_THROW(lay_out_markers({.dictionary = "DICT_6X6_250", .ids = {250}, .length = 0.05}),
               std::runtime_error);
  EXPECT_THROW(lay_out_markers({.ids = {}, .length = 0.05}), std::runtime_error);
  EXPECT_THROW(lay_out_markers({.ids = {40}, .length = 0.3}), std::runtime_error);
  EXPECT_THROW(lay_out_markers({.dictionary = "DICT_6X6_250", .ids = {40}, .length = 0.0}),
               std::runtime_error);
  EXPECT_THROW(lay_out_markers({.dictionary = "DICT_7X6", .ids = {40}, .length = 0.05}),
               std::runtime_error);
}

// The board that is printed is the one that --charuco means.
TEST(MarkerSheet, ACharucoBoardHasItsLayout) {
  const tracking::RegularBoard size = client::parse_charuco("5x7:0.035:0.026:3");
  const MarkerSheet sheet = lay_out_charuco({}, size);
  const tracking::MarkerBoard board = client::parse_charuco_board("5x7:0.035:0.026:3");
  const SheetPage& page = sheet.pages.at(0);
  ASSERT_EQ(page.markers.size(), board.markers.size());
  EXPECT_EQ(page.black.size() + page.markers.size(), 35u);
  const Square& first = page.markers[0].outline;
  for (std::size_t i = 0; i < board.markers.size(); ++i) {
    EXPECT_EQ(page.markers[i].id, board.markers[i].id);
    const glm::dvec3 moved = 1000.0 * (board.markers[i].corners[0] - board.markers[0].corners[0]);
    EXPECT_NEAR(page.markers[i].outline.x - first.x, moved.x, 1e-9);
    EXPECT_NEAR(page.markers[i].outline.y - first.y, -moved.y, 1e-9);  // the page's y is down
  }
  EXPECT_EQ(client::MarkerTracker({}, common::default_camera(840, 1188)).detect(draw(sheet)).size(),
            board.markers.size());
  EXPECT_GT(lay_out_charuco({}, client::parse_charuco("7x5:0.034:0.025")).width, 290.0);
  EXPECT_THROW(lay_out_charuco({}, client::parse_charuco("9x9:0.035:0.026")), std::runtime_error);
}

// The first text with these words.
SheetText text_with(const SheetPage& page, const std::string& words) {
  for (const SheetText& text : page.texts) {
    if (text.text.find(words) != std::string::npos) return text;
  }
  ADD_FAILURE() << words;
  return {};
}

SheetText caption_of(const SheetPage& page, int id) {
  const auto found = std::ranges::find(page.texts, std::to_string(id), &SheetText::text);
  if (found != page.texts.end()) return *found;
  ADD_FAILURE() << id;
  return {};
}

TEST(MarkerSheet, CaptionsLieBelowTheWhiteMargin) {
  const MarkerSheet sheet = lay_out_markers({.ids = {40}, .length = 0.05, .title = "a scene"});
  const SheetPage& page = sheet.pages.at(0);
  const SheetMarker& marker = page.markers.front();
  const SheetText caption = caption_of(page, marker.id);
  EXPECT_DOUBLE_EQ(marker.margin, 2 * 50.0 / 8);
  EXPECT_GE(caption.y - sheet.font_size, marker.outline.y + 50.0 + marker.margin - 1e-9);
  const double title = text_with(page, "a scene").y;
  const double measure = text_with(page, "DICT_6X6_250: black squares are 50 mm wide").y;
  EXPECT_LE(title, measure - sheet.font_size);
  EXPECT_LE(measure, marker.outline.y - marker.margin);
}

// Letters of a sans-serif font are narrower than this on average.
double widest(const SheetText& text, double font_size) {
  return 0.65 * font_size * static_cast<double>(text.text.size());
}

TEST(MarkerSheet, CaptionsStayInTheirColumnAndTextsOnThePage) {
  for (const double length : {0.01, 0.02, 0.05}) {
    const MarkerSheet sheet = lay_out_markers({.ids = {40, 7, 249, 100}, .length = length});
    ASSERT_EQ(sheet.pages.size(), 1u);
    for (const SheetMarker& marker : sheet.pages[0].markers) {
      const SheetText caption = caption_of(sheet.pages[0], marker.id);
      EXPECT_EQ(caption.x, marker.outline.x);
      EXPECT_LE(widest(caption, sheet.font_size), marker.outline.side + marker.margin) << length;
    }
    for (const SheetText& text : sheet.pages[0].texts) {
      EXPECT_LE(text.x + widest(text, sheet.font_size), sheet.width) << text.text;
    }
  }
}

TEST(MarkerSheet, EachPageSaysWhatToMeasure) {
  const MarkerSheet sheet = lay_out_markers({.ids = {1, 2}, .length = 0.12});
  ASSERT_EQ(sheet.pages.size(), 2u);
  for (const SheetPage& page : sheet.pages) {
    text_with(page, "DICT_6X6_250: black squares are 120 mm wide");
  }
}

// A scene's file may be named in Latin-1. Cairo draws nothing more after such a text.
TEST(MarkerSheet, TextsThatAreNoUtf8DoNotEmptyThePage) {
  const std::string file = testing::TempDir() + "latin1_" + std::to_string(getpid()) + ".svg";
  MarkerSheet sheet = lay_out_markers({.ids = {40}, .length = 0.05, .title = "caf\xe9.gltf"});
  for (const SheetText& text : sheet.pages[0].texts) {
    EXPECT_EQ(text.text.find("caf"), std::string::npos);
  }
  write_sheet(file, sheet);
  EXPECT_TRUE(std::filesystem::remove(file));
  sheet.pages[0].texts.push_back({10.0, 10.0, "caf\xe9"});
  EXPECT_THROW(write_sheet(file, sheet), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(MarkerSheet, WhatDoesNotFitOnOnePageComesOnTheNext) {
  const MarkerSheet sheet = lay_out_markers({.ids = {1, 2, 3}, .length = 0.12});
  ASSERT_EQ(sheet.pages.size(), 3u);
  EXPECT_EQ(sheet.pages[2].markers.at(0).id, 3);
  EXPECT_THROW(write_sheet("markers.svg", sheet), std::runtime_error);
  EXPECT_THROW(write_sheet("markers.png", sheet), std::runtime_error);
}

// As a printer would: the file's own page size at so many dots for each millimetre.
cv::Mat print(const MarkerSheet& sheet) {
  const std::string pdf = testing::TempDir() + "sheet_" + std::to_string(getpid()) + ".pdf";
  write_sheet(pdf, sheet);
  const std::string command = "pdftoppm -gray -singlefile -r " +
                              std::to_string(25.4 * kPixelsPerMillimetre) + " " + pdf + " " + pdf;
  const int status = std::system(command.c_str());
  std::filesystem::remove(pdf);
  if (status != 0) return {};
  cv::Mat page = cv::imread(pdf + ".pgm", cv::IMREAD_GRAYSCALE);
  std::filesystem::remove(pdf + ".pgm");
  return page;
}

TEST(MarkerSheet, APrintOfThePdfHasItsSizes) {
  if (std::system("command -v pdftoppm >/dev/null") != 0) {
    GTEST_SKIP() << "no pdftoppm (Debian's poppler-utils)";
  }
  for (const bool letter : {false, true}) {
    SheetOptions options{.ids = {40, 7}, .length = 0.04};
    set_paper(options, letter ? "letter" : "a4");
    const MarkerSheet sheet = lay_out_markers(options);
    const cv::Mat page = print(sheet);
    EXPECT_NEAR(page.cols, sheet.width * kPixelsPerMillimetre, 2.0);
    EXPECT_NEAR(page.rows, sheet.height * kPixelsPerMillimetre, 2.0);
    ASSERT_FALSE(page.empty());
    const common::CameraModel camera = common::default_camera(page.cols, page.rows);
    client::MarkerTracker tracker({.marker_length = 0.04}, camera);
    const auto poses = tracker.track(page);
    ASSERT_EQ(poses.size(), 2u);
    const double distance = camera.fx / (1000.0 * kPixelsPerMillimetre);
    for (const auto& pose : poses) EXPECT_NEAR(pose.translation.z, distance, 0.005 * distance);
    // The ruler's line: as many dark dots as it is long, and its ends are ticks.
    const int y = static_cast<int>(std::lround(sheet.ruler.y * kPixelsPerMillimetre));
    int most = 0;
    for (int row = y - 1; row <= y + 1; ++row) {
      most = std::max(most, page.cols - cv::countNonZero(page.row(row) > 128));
    }
    EXPECT_NEAR(most, sheet.ruler.length * kPixelsPerMillimetre, 2.0);
  }
}

}  // namespace
}  // namespace amalgam::sheet
