#include "client/tracking/board_description.h"

#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <opencv2/core/persistence.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "common/pose.h"
#include "tracking/opencv_file.h"

namespace amalgam::client {
namespace {

using std::filesystem::path;

[[noreturn]] void fail(const path& file, const std::string& what) {
  tracking::fail_file("board", file, what);
}

template <std::size_t Count>
std::array<double, Count> read_numbers(const cv::FileNode& node, const path& file,
                                       const std::string& what) {
  if (!node.isSeq() || node.size() != Count) {
    fail(file, what + " must be " + std::to_string(Count) + " numbers");
  }
  std::array<double, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i) {
    const cv::FileNode number = node[static_cast<int>(i)];
    if (!number.isInt() && !number.isReal()) fail(file, what + " holds something but numbers");
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

glm::dvec3 read_point(const cv::FileNode& node, const path& file, const std::string& what) {
  const auto [x, y, z] = read_numbers<3>(node, file, what);
  return {x, y, z};
}

glm::dquat read_rotation(const cv::FileNode& node, const path& file, const std::string& what) {
  if (node.empty()) return {1.0, 0.0, 0.0, 0.0};
  const auto [x, y, z, w] = read_numbers<4>(node, file, what);
  const glm::dquat rotation(w, x, y, z);
  if (!common::is_unit(rotation)) fail(file, what + " is no unit quaternion");
  return glm::normalize(rotation);
}

tracking::BoardMarker read_marker(const cv::FileNode& node, const cv::FileNode& common_length,
                                  const path& file) {
  if (!node.isMap() || !node["id"].isInt()) fail(file, "a marker without a whole number as id");
  const int id = static_cast<int>(node["id"]);
  const std::string name = "marker " + std::to_string(id) + ": ";
  const cv::FileNode corners = node["corners"];
  if (!corners.empty()) {
    if (!corners.isSeq() || corners.size() != 4) fail(file, name + "corners must be 4 points");
    tracking::BoardMarker marker{.id = id, .corners = {}};
    for (std::size_t i = 0; i < 4; ++i) {
      marker.corners[i] = read_point(corners[static_cast<int>(i)], file, name + "a corner");
    }
    return marker;
  }
  const cv::FileNode length = node["length"].empty() ? common_length : node["length"];
  if (!length.isReal() && !length.isInt()) fail(file, name + "neither a length nor corners");
  glm::dmat4 board_from_marker =
      glm::mat4_cast(read_rotation(node["rotation"], file, name + "rotation"));
  board_from_marker[3] = glm::dvec4(read_point(node["position"], file, name + "position"), 1.0);
  return tracking::square_marker(id, static_cast<double>(length), board_from_marker);
}

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<tracking::RegularBoard> parse_regular(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() != 3 && parts.size() != 4) return std::nullopt;
  const std::size_t x = parts[0].find('x');
  if (x == std::string_view::npos) return std::nullopt;
  const auto columns = parse<int>(parts[0].substr(0, x));
  const auto rows = parse<int>(parts[0].substr(x + 1));
  const auto first = parse<double>(parts[1]), second = parse<double>(parts[2]);
  const auto id = parts.size() == 4 ? parse<int>(parts[3]) : std::optional(0);
  constexpr int kMaxSide = 100, kMaxId = 1'000'000;  // no board's last id overflows
  if (!columns || !rows || !first || !second || !id) return std::nullopt;
  if (*columns < 1 || *rows < 1 || *columns > kMaxSide || *rows > kMaxSide) return std::nullopt;
  if (*id < 0 || *id > kMaxId) return std::nullopt;
  return tracking::RegularBoard{*columns, *rows, *first, *second, *id};
}

tracking::MarkerBoard checked(tracking::MarkerBoard board, const std::string& text) {
  const std::string defect = describe_defect(board);
  if (!defect.empty()) throw std::runtime_error("board '" + text + "': " + defect);
  return board;
}

}  // namespace

tracking::MarkerBoard load_board(const path& file) {
  const std::string text = tracking::read_small_text("board", file);
  const tracking::QuietOpenCv quiet;
  tracking::MarkerBoard board;
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode markers = storage["markers"];
    if (!markers.isSeq()) fail(file, "has no list of markers");
    for (const cv::FileNode& marker : markers) {
      board.markers.push_back(read_marker(marker, storage["marker_length"], file));
    }
  } catch (const cv::Exception& error) {
    fail(file, "is not an OpenCV file (" + tracking::first_line(error) + ")");
  }
  if (const std::string defect = describe_defect(board); !defect.empty()) fail(file, defect);
  return board;
}

tracking::MarkerBoard parse_grid_board(const std::string& text) {
  const auto grid = parse_regular(text);
  if (!grid || !(grid->first_length > 0) || !(grid->second_length >= 0)) {
    throw std::runtime_error("'" + text + "' is not COLUMNSxROWS:MARKER:GAP[:FIRST_ID]");
  }
  return checked(tracking::make_grid_board(grid->columns, grid->rows, grid->first_length,
                                           grid->second_length, grid->first_id),
                 text);
}

tracking::RegularBoard parse_charuco(const std::string& text) {
  const auto board = parse_regular(text);
  if (!board || !(board->second_length > 0) || !(board->first_length > board->second_length)) {
    throw std::runtime_error("'" + text +
                             "' is not COLUMNSxROWS:SQUARE:MARKER[:FIRST_ID] with markers smaller "
                             "than squares");
  }
  return *board;
}

tracking::MarkerBoard parse_charuco_board(const std::string& text) {
  const tracking::RegularBoard board = parse_charuco(text);
  return checked(tracking::make_charuco_board(board.columns, board.rows, board.first_length,
                                              board.second_length, board.first_id),
                 text);
}

}  // namespace amalgam::client
