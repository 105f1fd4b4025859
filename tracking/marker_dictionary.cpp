#include "tracking/marker_dictionary.h"

#include <algorithm>
#include <array>
#include <opencv2/core/persistence.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tracking/opencv_file.h"

namespace amalgam::tracking {
namespace {

using cv::aruco::PREDEFINED_DICTIONARY_NAME;

constexpr std::array<std::pair<std::string_view, PREDEFINED_DICTIONARY_NAME>, 21> kPredefined{{
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
    {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
    {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11},
}};

constexpr const char* kKind = "marker dictionary";

bool is_file_name(std::string_view name) {
  return name.ends_with(".yml") || name.ends_with(".yaml");
}

// What readDictionary() takes for granted. It writes beyond the marker for longer codes, and leaves
// the rest of shorter ones as it was in memory.
std::string describe_defect(const cv::FileNode& root) {
  constexpr int kMaxSide = 10, kMaxMarkers = 1024;
  const cv::FileNode side = root["markersize"], count = root["nmarkers"];
  if (!side.isInt() || static_cast<int>(side) < 1 || static_cast<int>(side) > kMaxSide) {
    return "markersize is no whole number from 1 to " + std::to_string(kMaxSide);
  }
  if (!count.isInt() || static_cast<int>(count) < 1 || static_cast<int>(count) > kMaxMarkers) {
    return "nmarkers is no whole number from 1 to " + std::to_string(kMaxMarkers);
  }
  const auto cells = static_cast<std::size_t>(static_cast<int>(side) * static_cast<int>(side));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const std::string name = "marker_" + std::to_string(i);
    const cv::FileNode code = root[name];
    if (!code.isString() || std::string(code).size() != cells) {
      return name + " is no text of " + std::to_string(cells) + " digits";
    }
  }
  return {};
}

cv::Ptr<cv::aruco::Dictionary> read_dictionary(const std::string& file) {
  const std::string text = read_small_text(kKind, file);
  const QuietOpenCv quiet;
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode root = storage.isOpened() ? storage.root() : cv::FileNode();
    if (!root.isMap()) fail_file(kKind, file, "is not an OpenCV file");
    if (const std::string defect = describe_defect(root); !defect.empty()) {
      fail_file(kKind, file, defect);
    }
    auto dictionary = cv::makePtr<cv::aruco::Dictionary>();
    if (!dictionary->readDictionary(root)) fail_file(kKind, file, "cannot be read");
    return dictionary;
  } catch (const cv::Exception& error) {
    fail_file(kKind, file, "is not an OpenCV file (" + first_line(error) + ")");
  }
}

[[noreturn]] void fail_unknown(const std::string& name) {
  std::string known;
  for (const auto& predefined : kPredefined) {
    known += ' ';
    known += predefined.first;
  }
  throw std::runtime_error("unknown marker dictionary '" + name + "'; known are" + known);
}

}  // namespace

cv::Ptr<cv::aruco::Dictionary> find_dictionary(const std::string& name) {
  for (const auto& [known_name, value] : kPredefined) {
    if (known_name == name) return cv::aruco::getPredefinedDictionary(value);
  }
  if (is_file_name(name)) return read_dictionary(name);
  fail_unknown(name);
}

const std::string& predefined_dictionary(const std::string& name) {
  const auto is_it = [&](const auto& predefined) { return predefined.first == name; };
  if (std::ranges::none_of(kPredefined, is_it)) fail_unknown(name);
  return name;
}

}  // namespace amalgam::tracking
