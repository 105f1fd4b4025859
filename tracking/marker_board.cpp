#include "tracking/marker_board.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "common/pose.h"

namespace amalgam::tracking {
namespace {

glm::dvec3 moved(const glm::dmat4& target_from_source, const glm::dvec3& point) {
  return {target_from_source * glm::dvec4(point, 1.0)};
}

// A marker in cell (column, row) of a regular layout, row 0 at the top.
BoardMarker in_cell(int id, double marker_length, double pitch, glm::ivec2 cell, glm::ivec2 cells) {
  const double x = (cell.x - 0.5 * (cells.x - 1)) * pitch;
  const double y = (0.5 * (cells.y - 1) - cell.y) * pitch;
  return square_marker(id, marker_length, glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, 0)));
}

bool is_square(const BoardMarker& marker) {
  const auto& c = marker.corners;
  double shortest = INFINITY, longest = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double side = glm::distance(c[i], c[(i + 1) % c.size()]);
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  const double diagonals = glm::distance(c[0], c[2]) / glm::distance(c[1], c[3]);
  constexpr double kTolerance = 1.2;
  return shortest > 0 && longest <= kTolerance * shortest && diagonals <= kTolerance &&
         diagonals >= 1 / kTolerance;
}

}  // namespace

const BoardMarker* MarkerBoard::find(int id) const {
  const auto found = std::ranges::find(markers, id, &BoardMarker::id);
  return found == markers.end() ? nullptr : &*found;
}

BoardMarker square_marker(int id, double length, const glm::dmat4& board_from_marker) {
  const double half = 0.5 * length;
  BoardMarker marker{
      .id = id,
      .corners = {{{-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}}}};
  for (glm::dvec3& corner : marker.corners) corner = moved(board_from_marker, corner);
  return marker;
}

MarkerBoard make_grid_board(int columns, int rows, double marker_length, double gap, int first_id) {
  MarkerBoard board;
  int id = first_id;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      board.markers.push_back(
          in_cell(id++, marker_length, marker_length + gap, {column, row}, {columns, rows}));
    }
  }
  return board;
}

namespace {

std::vector<BoardMarker> charuco_layout(int columns, int rows, double square_length,
                                        double marker_length, int first_id,
                                        bool top_left_is_black) {
  std::vector<BoardMarker> markers;
  int id = first_id;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool is_black = ((row + column) % 2 == 0) == top_left_is_black;
      if (is_black) continue;
      markers.push_back(
          in_cell(id++, marker_length, square_length, {column, row}, {columns, rows}));
    }
  }
  return markers;
}

}  // namespace

MarkerBoard make_charuco_board(int columns, int rows, double square_length, double marker_length,
                               int first_id) {
  MarkerBoard board;
  board.markers = charuco_layout(columns, rows, square_length, marker_length, first_id, true);
  if (rows % 2 == 0) {
    board.older_markers =
        charuco_layout(columns, rows, square_length, marker_length, first_id, false);
  }
  return board;
}

glm::dmat4 frame_of(const BoardMarker& marker) {
  const auto& [top_left, top_right, bottom_right, bottom_left] = marker.corners;
  const glm::dvec3 x = glm::normalize(top_right + bottom_right - top_left - bottom_left);
  const glm::dvec3 up = top_left + top_right - bottom_left - bottom_right;
  const glm::dvec3 z = glm::normalize(glm::cross(x, up));
  const glm::dvec3 centre = 0.25 * (top_left + top_right + bottom_right + bottom_left);
  return {glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0),
          glm::dvec4(centre, 1)};
}

MarkerBoard placed_on(const MarkerBoard& board, int world_marker) {
  const auto placed = [&](std::vector<BoardMarker> markers) {
    const auto world = std::ranges::find(markers, world_marker, &BoardMarker::id);
    if (world == markers.end()) return markers;
    const glm::dmat4 world_from_board = common::rigid_inverse(frame_of(*world));
    for (BoardMarker& marker : markers) {
      for (glm::dvec3& corner : marker.corners) corner = moved(world_from_board, corner);
    }
    return markers;
  };
  return {placed(board.markers), placed(board.older_markers)};
}

std::string describe_defect(const MarkerBoard& board) {
  constexpr std::size_t kMaxMarkers = 1024;  // the largest of OpenCV's dictionaries has 1000
  constexpr double kMaxDistance = 100.0;     // metres
  if (board.markers.empty()) return "has no markers";
  if (board.markers.size() > kMaxMarkers) return "has more than 1024 markers";
  std::set<int> ids;
  for (const BoardMarker& marker : board.markers) {
    const std::string name = "marker " + std::to_string(marker.id);
    if (marker.id < 0) return name + ": ids begin at 0";
    if (!ids.insert(marker.id).second) return name + " is there twice";
    for (const glm::dvec3& corner : marker.corners) {
      // Written so that a NaN fails.
      if (!(glm::length(corner) <= kMaxDistance)) return name + " is not within 100 m";
    }
    if (!is_square(marker)) return name + ": its corners are no square";
  }
  return {};
}

}  // namespace amalgam::tracking
