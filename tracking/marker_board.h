// A board: several markers fixed to each other. All their seen corners together give one pose.
//
// The board's frame is like a marker's: x to its right, y to its top, z out of the paper; metres.
// Objects stand on the world marker, so a board is first placed relative to it: see placed_on().
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace amalgam::tracking {

struct BoardMarker {
  int id = 0;
  // Top left, top right, bottom right, bottom left of the printed marker, in the board's frame.
  std::array<glm::dvec3, 4> corners{};
};

struct MarkerBoard {
  std::vector<BoardMarker> markers;
  // The same ids as OpenCV laid them out before 4.6, if that differs (opencv_contrib issue 3291): a
  // ChArUco board with an even number of rows had its bottom left square black. Which of the two
  // was printed shows in the picture (BoardTracker).
  std::vector<BoardMarker> older_markers{};

  const BoardMarker* find(int id) const;  // null if the board has no such marker
};

// A square marker lying anywhere in the board's frame; length is its side in metres.
BoardMarker square_marker(int id, double length, const glm::dmat4& board_from_marker);

// One of OpenCV's regular boards: its sides in markers or squares; lengths in metres.
struct RegularBoard {
  int columns = 0, rows = 0;
  double first_length = 0.0;   // of a marker (grid) or a square (ChArUco)
  double second_length = 0.0;  // of a gap (grid) or a marker (ChArUco)
  int first_id = 0;
};

// The layouts of OpenCV's generators: ids ascend along rows, the top row first; the origin is the
// board's centre. Lengths in metres. A ChArUco board's markers lie in its white squares, with the
// top left square black. Its chessboard corners are not used.
MarkerBoard make_grid_board(int columns, int rows, double marker_length, double gap, int first_id);
MarkerBoard make_charuco_board(int columns, int rows, double square_length, double marker_length,
                               int first_id);

// board_from_marker: the frame that a marker's four corners span.
glm::dmat4 frame_of(const BoardMarker& marker);

// The board in the world marker's frame. If the world marker is part of the board, it moves to the
// origin; otherwise the board's frame stands for the world marker's.
MarkerBoard placed_on(const MarkerBoard& board, int world_marker);

// Empty, or the board's defect: no markers or more than 1024, a negative or repeated id, corners
// that are not finite, further than 100 m away, or not a square to within 20 %.
std::string describe_defect(const MarkerBoard& board);

}  // namespace amalgam::tracking
