// Reads board descriptions: a layout file, or the size of one of OpenCV's regular boards.
#pragma once

#include <filesystem>
#include <string>

#include "tracking/marker_board.h"

namespace amalgam::client {

// A layout in OpenCV's file formats (YAML beginning with "%YAML:1.0", JSON, XML):
//
//   marker_length: 0.05                       # metres; of markers that do not state their own
//   markers:
//     - { id: 40, position: [0, 0, 0] }       # centre, metres, in the layout's frame
//     - { id: 23, position: [0.2, 0, 0.1], rotation: [0, 0.7071068, 0, 0.7071068], length: 0.04 }
//     - { id: 7, corners: [[0, 0.05, 0], [0.05, 0.05, 0], [0.05, 0, 0], [0, 0, 0]] }
//
// rotation: layout_from_marker as a unit quaternion x y z w; identity if left out. corners: top
// left, top right, bottom right, bottom left. Throws std::runtime_error with one line.
tracking::MarkerBoard load_board(const std::filesystem::path& file);

// "COLUMNSxROWS:MARKER:GAP[:FIRST_ID]", lengths in metres, as "5x7:0.04:0.01:0". Throws
// std::runtime_error.
tracking::MarkerBoard parse_grid_board(const std::string& text);

// "COLUMNSxROWS:SQUARE:MARKER[:FIRST_ID]", counting the chessboard's squares. Throws
// std::runtime_error.
tracking::RegularBoard parse_charuco(const std::string& text);
tracking::MarkerBoard parse_charuco_board(const std::string& text);

}  // namespace amalgam::client
