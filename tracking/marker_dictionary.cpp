#include "tracking/marker_dictionary.h"

#include <array>
#include <opencv2/core/persistence.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

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

bool is_file_name(std::string_view name) {
  return name.ends_with(".yml") || name.ends_with(".yaml");
}

cv::Ptr<cv::aruco::Dictionary> read_dictionary(const std::string& file) {
  const std::string defect = "marker dictionary " + file + " cannot be read";
  try {
    const cv::FileStorage storage(file, cv::FileStorage::READ);
    auto dictionary = cv::makePtr<cv::aruco::Dictionary>();
    if (!storage.isOpened() || !dictionary->readDictionary(storage.root())) {
      throw std::runtime_error(defect);
    }
    return dictionary;
  } catch (const cv::Exception&) {
    throw std::runtime_error(defect);
  }
}

}  // namespace

cv::Ptr<cv::aruco::Dictionary> find_dictionary(const std::string& name) {
  std::string known;
  for (const auto& [known_name, value] : kPredefined) {
    if (known_name == name) return cv::aruco::getPredefinedDictionary(value);
    known += ' ';
    known += known_name;
  }
  if (is_file_name(name)) return read_dictionary(name);
  throw std::runtime_error("unknown marker dictionary '" + name + "'; known are" + known);
}

}  // namespace amalgam::tracking
