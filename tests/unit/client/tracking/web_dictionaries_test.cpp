// The browser page's table of marker dictionaries against OpenCV's own, which the native client
// uses: a page with another table would find other markers, or none.
// AMALGAM_REFRESH_GOLDENS=1 writes it anew.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tracking/marker_dictionary.h"

namespace amalgam::client {
namespace {

using Json = nlohmann::ordered_json;

const std::string kFile =
    std::string(AMALGAM_SOURCE_DIR) + "/client/web/source/markers/opencv.json";

// Dictionaries of one family share their codes: the smaller ones are the beginnings of the largest.
struct Family {
  const char* name;
  std::array<int, 4> counts;  // 0: there is no such dictionary
};

constexpr std::array kFamilies{
    Family{"DICT_4X4_", {50, 100, 250, 1000}}, Family{"DICT_5X5_", {50, 100, 250, 1000}},
    Family{"DICT_6X6_", {50, 100, 250, 1000}}, Family{"DICT_7X7_", {50, 100, 250, 1000}}};

constexpr std::array kSingles{"DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5", "DICT_APRILTAG_25h9",
                              "DICT_APRILTAG_36h10", "DICT_APRILTAG_36h11"};

// The bits of a marker's pattern row by row, white is 1, as one hexadecimal number.
std::string code_of(const cv::aruco::Dictionary& dictionary, int id) {
  const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(
      dictionary.bytesList.rowRange(id, id + 1), dictionary.markerSize);
  const int total = dictionary.markerSize * dictionary.markerSize;
  std::string hex;
  int digit = 0;
  for (int i = 0; i < total; ++i) {
    digit =
        2 * digit + bits.at<unsigned char>(i / dictionary.markerSize, i % dictionary.markerSize);
    // The last digit is the one that ends with the last bit.
    if ((total - 1 - i) % 4 == 0) {
      hex += "0123456789abcdef"[digit];
      digit = 0;
    }
  }
  return hex;
}

Json codes_of(const cv::aruco::Dictionary& dictionary) {
  std::string codes;
  for (int id = 0; id < dictionary.bytesList.rows; ++id) {
    codes += (id == 0 ? "" : " ") + code_of(dictionary, id);
  }
  return codes;
}

Json entry(const std::string& name, const std::string& codes) {
  const auto dictionary = tracking::find_dictionary(name);
  return {{"bits", dictionary->markerSize},
          {"count", dictionary->bytesList.rows},
          {"correct", dictionary->maxCorrectionBits},
          {"codes", codes}};
}

Json make_table() {
  Json table{{"dictionaries", Json::object()}, {"codes", Json::object()}};
  for (const Family& family : kFamilies) {
    const std::string largest = family.name + std::to_string(family.counts.back());
    table["codes"][largest] = codes_of(*tracking::find_dictionary(largest));
    for (const int count : family.counts) {
      const std::string name = family.name + std::to_string(count);
      table["dictionaries"][name] = entry(name, largest);
    }
  }
  for (const char* name : kSingles) {
    table["codes"][name] = codes_of(*tracking::find_dictionary(name));
    table["dictionaries"][name] = entry(name, name);
  }
  return table;
}

TEST(WebDictionaries, AreThoseOfTheNativeClient) {
  const Json expected = make_table();
  if (std::getenv("AMALGAM_REFRESH_GOLDENS") != nullptr) {
    std::ofstream(kFile) << expected.dump(1) << '\n';
  }
  std::ifstream file(kFile);
  ASSERT_TRUE(file) << kFile;
  EXPECT_TRUE(Json::parse(file) == expected) << kFile << " is not what OpenCV has";
}

// What lets the file keep one list of codes for a family.
TEST(WebDictionaries, SmallOnesAreTheBeginningsOfTheLargest) {
  for (const Family& family : kFamilies) {
    const auto largest =
        tracking::find_dictionary(family.name + std::to_string(family.counts.back()));
    for (const int count : family.counts) {
      const auto small = tracking::find_dictionary(family.name + std::to_string(count));
      ASSERT_EQ(small->bytesList.rows, count);
      for (int id = 0; id < count; ++id) {
        EXPECT_EQ(code_of(*small, id), code_of(*largest, id)) << family.name << count << ' ' << id;
      }
    }
  }
}

}  // namespace
}  // namespace amalgam::client
