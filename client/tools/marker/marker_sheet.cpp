#include "client/tools/marker/marker_sheet.h"

#include <algorithm>
#include <cstdio>
#include <opencv2/aruco.hpp>
#include <stdexcept>

#include "client/tracking/marker_dictionary.h"

namespace amalgam::tools {
namespace {

constexpr double kPageMargin = 10.0;  // mm: what printers leave white
constexpr double kCaption = 8.0;      // mm below each marker's margin
constexpr double kFontSize = 3.2;     // mm

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string rectangle(const Square& square, const char* fill) {
  return "<rect x=\"" + millimetres(square.x) + "\" y=\"" + millimetres(square.y) + "\" width=\"" +
         millimetres(square.side) + "\" height=\"" + millimetres(square.side) + "\" fill=\"" +
         fill + "\"/>\n";
}

// A pixel a cell, the black border included.
cv::Mat cells_of(const cv::Ptr<cv::aruco::Dictionary>& dictionary, int id) {
  if (id < 0 || id >= dictionary->bytesList.rows) {
    throw std::runtime_error("there is no marker " + std::to_string(id) +
                             " in the dictionary, which has 0 to " +
                             std::to_string(dictionary->bytesList.rows - 1));
  }
  cv::Mat cells;
  cv::aruco::drawMarker(dictionary, id, dictionary->markerSize + 2, cells);
  return cells;
}

SheetMarker make_marker(int id, const cv::Mat& cells, const Square& outline, double margin) {
  SheetMarker marker{id, outline, {}, margin};
  const double cell = outline.side / cells.cols;
  for (int y = 0; y < cells.rows; ++y) {
    for (int x = 0; x < cells.cols; ++x) {
      if (cells.at<unsigned char>(y, x) == 0) continue;
      marker.white.push_back({outline.x + x * cell, outline.y + y * cell, cell});
    }
  }
  return marker;
}

}  // namespace

MarkerSheet lay_out_markers(const std::string& dictionary, const std::vector<int>& ids,
                            double length, double page_width, double page_height) {
  const auto known = client::find_dictionary(dictionary);
  const double side = 1000.0 * length;
  if (!(side > 0.0)) throw std::runtime_error("a marker's length must be above 0 m");
  const double margin = 2.0 * side / (known->markerSize + 2);
  const double across = side + 2.0 * margin, down = across + kCaption;

  MarkerSheet sheet{page_width, page_height, dictionary, {}};
  double x = kPageMargin, y = kPageMargin;
  for (const int id : ids) {
    if (x + across > page_width - kPageMargin) {
      x = kPageMargin;
      y += down;
    }
    if (x + across > page_width - kPageMargin || y + down > page_height - kPageMargin) {
      throw std::runtime_error(std::to_string(ids.size()) + " markers of " + millimetres(side) +
                               " mm do not fit on a page of " + millimetres(page_width) + " x " +
                               millimetres(page_height) + " mm; print fewer at a time");
    }
    sheet.markers.push_back(
        make_marker(id, cells_of(known, id), {x + margin, y + margin, side}, margin));
    x += across;
  }
  return sheet;
}

std::string to_svg(const MarkerSheet& sheet) {
  const std::string width = millimetres(sheet.width), height = millimetres(sheet.height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
                    "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
                    "\" shape-rendering=\"crispEdges\">\n<rect width=\"100%\" height=\"100%\" "
                    "fill=\"white\"/>\n";
  for (const SheetMarker& marker : sheet.markers) {
    svg += rectangle(marker.outline, "black");
    for (const Square& cell : marker.white) svg += rectangle(cell, "white");
    const Square& outline = marker.outline;
    svg += "<text x=\"" + millimetres(outline.x) + "\" y=\"" +
           millimetres(outline.y + outline.side + marker.margin + kFontSize) +
           "\" font-family=\"sans-serif\" font-size=\"" + millimetres(kFontSize) +
           "\" fill=\"#444\">" + sheet.dictionary + ", marker " + std::to_string(marker.id) +
           ": the black square is " + millimetres(outline.side) + " mm wide</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace amalgam::tools
