// A printed page, looked at by the tracker: the markers are there and as large as they say.
#include "client/tools/marker/marker_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "client/tracking/marker_tracker.h"

namespace amalgam::tools {
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
  for (const SheetMarker& marker : sheet.markers) {
    fill(marker.outline, 0);
    for (const Square& cell : marker.white) fill(cell, 255);
  }
  return page;
}

// Tag 0 of tag36h11 as the AprilTag project has it, by rows, is 0xd5d628584; OpenCV's dictionary
// has it turned by 180 degrees, that is, with its bits from the end (README, Scenes).
TEST(MarkerSheet, AprilTagsAreTurnedByHalf) {
  const MarkerSheet sheet = lay_out_markers("DICT_APRILTAG_36h11", std::vector<int>{0}, 0.08);
  std::uint64_t bits = 0;
  for (const Square& cell : sheet.markers.at(0).white) {
    const Square& outline = sheet.markers[0].outline;
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
  const MarkerSheet sheet = lay_out_markers("DICT_6X6_250", ids, 0.04);
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
  const MarkerSheet sheet = lay_out_markers("DICT_4X4_50", {0, 1, 2, 3, 4}, 0.05);
  for (const SheetMarker& marker : sheet.markers) {
    EXPECT_GE(marker.outline.x, 10.0 + 2 * 50.0 / 6);
    EXPECT_LE(marker.outline.x + 50.0, 200.0 - 2 * 50.0 / 6);
    EXPECT_LE(marker.outline.y + 50.0, 287.0);
    for (const SheetMarker& other : sheet.markers) {
      if (other.id == marker.id) continue;
      const bool apart = std::abs(other.outline.x - marker.outline.x) > 50.0 ||
                         std::abs(other.outline.y - marker.outline.y) > 50.0;
      EXPECT_TRUE(apart) << marker.id << " and " << other.id;
    }
  }
}

TEST(MarkerSheet, WhatCannotBePrintedIsSaid) {
  EXPECT_THROW(lay_out_markers("DICT_6X6_250", {250}, 0.05), std::runtime_error);
  EXPECT_THROW(lay_out_markers("DICT_6X6_250", {40}, 0.3), std::runtime_error);
  EXPECT_THROW(lay_out_markers("DICT_6X6_250", {40}, 0.0), std::runtime_error);
  EXPECT_THROW(lay_out_markers("DICT_7X6", {40}, 0.05), std::runtime_error);
}

TEST(MarkerSheet, SvgHasMillimetresAndACaption) {
  const std::string svg = to_svg(lay_out_markers("DICT_6X6_250", {40}, 0.05));
  EXPECT_THAT(svg, testing::HasSubstr("width=\"210.000mm\" height=\"297.000mm\""));
  EXPECT_THAT(svg,
              testing::HasSubstr("DICT_6X6_250, marker 40: the black square is 50.000 mm wide"));
}

// Print in the white margin would hide the marker's edge from the detector.
TEST(MarkerSheet, CaptionsLieBelowTheWhiteMargin) {
  const MarkerSheet sheet = lay_out_markers("DICT_6X6_250", {40}, 0.05);
  const std::string svg = to_svg(sheet);
  const std::string before = "<text x=\"22.500\" y=\"";
  const std::size_t at = svg.find(before);
  ASSERT_NE(at, std::string::npos);
  const double baseline = std::stod(svg.substr(at + before.size()));
  const double letters = 3.2;  // mm above the baseline, at most
  const SheetMarker& marker = sheet.markers.front();
  EXPECT_DOUBLE_EQ(marker.margin, 2 * 50.0 / 8);
  EXPECT_GE(baseline - letters, marker.outline.y + 50.0 + marker.margin - 1e-3);
}

}  // namespace
}  // namespace amalgam::tools
