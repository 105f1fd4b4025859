// Pages of markers to be printed at their true size.
//
// Page frame: millimetres, x right, y down, origin at the top left corner.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracking/marker_board.h"

namespace amalgam::sheet {

struct Square {
  double x = 0.0, y = 0.0, side = 0.0;  // top left corner and side, millimetres
};

struct SheetMarker {
  int id = 0;
  Square outline;             // of the black square that gives the marker its length
  std::vector<Square> white;  // the cells of its code that are white, inside the outline
  double margin = 0.0;        // white on all sides of the outline, millimetres
};

struct SheetText {
  double x = 0.0, y = 0.0;  // where the baseline begins, millimetres
  std::string text;
};

struct SheetPage {
  std::vector<Square> black;  // of a chessboard
  std::vector<SheetMarker> markers;
  std::vector<SheetText> texts;
};

// Each page has a ruler, so that a print can be checked.
struct Ruler {
  double x = 0.0, y = 0.0;  // its left end, on the line that the ticks stand on, millimetres
  double length = 100.0;    // millimetres, a tick at each tenth
};

struct MarkerSheet {
  double width = 210.0, height = 297.0;  // A4
  double font_size = 3.2;                // millimetres
  std::string dictionary;
  Ruler ruler;
  std::vector<SheetPage> pages;
};

struct SheetOptions {
  std::string dictionary = "DICT_6X6_250";  // see tracking::find_dictionary()
  std::vector<int> ids{};
  double length = 0.05;  // side of the black square, metres
  std::string title{};   // on each page; empty: none
  double page_width = 210.0, page_height = 297.0;
};

// The sheets of paper that pages are made for: "a4" and "letter". Sets the page's size; throws
// std::runtime_error for another name.
void set_paper(SheetOptions& options, std::string_view name);

// Places the markers in rows, each with a white margin of two cells and its id below. Each page
// says the dictionary and the length to measure after printing. A title that is no UTF-8 is left
// out. Throws std::runtime_error for an unknown dictionary or id, a length that is not positive, or
// a marker that does not fit on a page.
MarkerSheet lay_out_markers(const SheetOptions& options);

// A ChArUco board on one page, wide or high as it fits. ids and length of the options are not used.
// Throws std::runtime_error as above, or if it fits neither way.
MarkerSheet lay_out_charuco(const SheetOptions& options, const tracking::RegularBoard& board);

}  // namespace amalgam::sheet
