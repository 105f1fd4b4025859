// A page of markers to be printed at their true size.
//
// Page frame: millimetres, x right, y down, origin at the top left corner.
#pragma once

#include <string>
#include <vector>

namespace amalgam::tools {

struct Square {
  double x = 0.0, y = 0.0, side = 0.0;  // top left corner and side, millimetres
};

struct SheetMarker {
  int id = 0;
  Square outline;             // of the black square that gives the marker its length
  std::vector<Square> white;  // the cells of its code that are white, inside the outline
  double margin = 0.0;        // white on all sides of the outline, millimetres
};

struct MarkerSheet {
  double width = 210.0, height = 297.0;  // A4
  std::string dictionary;
  std::vector<SheetMarker> markers;
};

// Places the markers in rows, each with a white margin of two cells. length: side of the black
// square, metres. Throws std::runtime_error for an unknown dictionary or id, a length that is not
// positive, or markers that do not fit on one page.
MarkerSheet lay_out_markers(const std::string& dictionary, const std::vector<int>& ids,
                            double length, double page_width = 210.0, double page_height = 297.0);

// With a caption under each marker that says its id and the length to measure after printing.
std::string to_svg(const MarkerSheet& sheet);

}  // namespace amalgam::tools
