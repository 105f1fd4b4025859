#include "sheet/marker_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/aruco.hpp>
#include <stdexcept>
#include <utility>

#include "common/utf8.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::sheet {
namespace {

constexpr double kPageMargin = 10.0;  // mm: what printers leave white
constexpr double kLine = 8.0;         // mm: a line of text with what is left free around it
constexpr double kRulerText = 5.0;    // mm from the ruler's line to the bottom of its text
constexpr double kRulerHeight = 10.0;

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", std::round(1000.0 * value) / 1000.0);
  return text;
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

bool has_title(const SheetOptions& options) {
  return !options.title.empty() && common::is_utf8(options.title);
}

// One page with the title and the ruler.
MarkerSheet blank_sheet(const SheetOptions& options) {
  MarkerSheet sheet;
  sheet.width = options.page_width;
  sheet.height = options.page_height;
  sheet.dictionary = options.dictionary;
  sheet.ruler = {.x = kPageMargin, .y = options.page_height - kPageMargin - kRulerText};
  SheetPage& page = sheet.pages.emplace_back();
  // A file's name may be anything; it is left out where it is no text.
  if (has_title(options)) {
    page.texts.push_back({kPageMargin, kPageMargin + sheet.font_size, options.title});
  }
  page.texts.push_back({sheet.ruler.x, sheet.ruler.y + kRulerText,
                        "Print at 100 %. This line is " + millimetres(sheet.ruler.length) +
                            " mm long on paper; if not, the markers have the wrong size."});
  return sheet;
}

}  // namespace

void set_paper(SheetOptions& options, std::string_view name) {
  if (name == "a4") {
    options.page_width = 210.0;
    options.page_height = 297.0;
  } else if (name == "letter") {
    options.page_width = 215.9;
    options.page_height = 279.4;
  } else {
    throw std::runtime_error("paper is a4 or letter, not '" + std::string(name) + "'");
  }
}

MarkerSheet lay_out_markers(const SheetOptions& options) {
  if (options.ids.empty()) throw std::runtime_error("there are no markers to print");
  const auto known = tracking::find_dictionary(options.dictionary);
  const double side = 1000.0 * options.length;
  if (!(side > 0.0)) throw std::runtime_error("a marker's length must be above 0 m");
  const double margin = 2.0 * side / (known->markerSize + 2);
  const double across = side + 2.0 * margin, down = across + kLine;
  const double right = options.page_width - kPageMargin;
  const double bottom = options.page_height - kPageMargin - kRulerHeight;
  const double head = kPageMargin + (has_title(options) ? kLine : 0.0), top = head + kLine;
  if (kPageMargin + across > right || top + down > bottom) {
    throw std::runtime_error("a marker of " + millimetres(side) + " mm does not fit on a page of " +
                             millimetres(options.page_width) + " x " +
                             millimetres(options.page_height) + " mm");
  }
  // Said once: beside small markers there is room for their numbers only.
  MarkerSheet sheet = blank_sheet(options);
  SheetPage blank = sheet.pages.front();
  blank.texts.push_back(
      {kPageMargin, head + sheet.font_size,
       options.dictionary + ": black squares are " + millimetres(side) + " mm wide"});
  sheet.pages = {blank};
  double x = kPageMargin, y = top;
  for (const int id : options.ids) {
    if (x + across > right) {
      x = kPageMargin;
      y += down;
    }
    if (y + down > bottom) {
      sheet.pages.push_back(blank);
      y = top;
    }
    SheetPage& page = sheet.pages.back();
    const Square outline{x + margin, y + margin, side};
    page.markers.push_back(make_marker(id, cells_of(known, id), outline, margin));
    // Print in the white margin would hide the marker's edge from detectors.
    page.texts.push_back(
        {outline.x, outline.y + side + margin + sheet.font_size, std::to_string(id)});
    x += across;
  }
  return sheet;
}

MarkerSheet lay_out_charuco(const SheetOptions& options, const tracking::RegularBoard& board) {
  const double square = 1000.0 * board.first_length, marker = 1000.0 * board.second_length;
  const double width = board.columns * square, height = board.rows * square;
  SheetOptions page = options;
  page.ids.clear();
  page.length = marker / 1000.0;
  const auto fits = [&] {
    return width <= page.page_width - 2.0 * kPageMargin &&
           height <= page.page_height - 2.0 * kPageMargin - kRulerHeight - kLine;
  };
  if (!fits()) std::swap(page.page_width, page.page_height);
  if (!fits()) {
    throw std::runtime_error("a board of " + millimetres(width) + " x " + millimetres(height) +
                             " mm does not fit on a page");
  }
  MarkerSheet sheet = blank_sheet(page);
  SheetPage& only = sheet.pages.front();
  const double left = 0.5 * (sheet.width - width), top = kPageMargin + kLine;
  const auto known = tracking::find_dictionary(options.dictionary);
  int id = board.first_id;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      const double x = left + column * square, y = top + row * square;
      if ((row + column) % 2 == 0) {
        only.black.push_back({x, y, square});
        continue;
      }
      const double gap = 0.5 * (square - marker);
      only.markers.push_back(make_marker(id, cells_of(known, id), {x + gap, y + gap, marker}, gap));
      ++id;
    }
  }
  return sheet;
}

}  // namespace amalgam::sheet
