#include "tracking/marker_dictionary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace amalgam::tracking {
namespace {

using testing::HasSubstr;

std::string file_with(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("dictionary_" + std::string(test->name()) + ".yml");
  std::ofstream(file) << text;
  return file.string();
}

std::string text_with(const std::string& count, const std::string& side,
                      const std::vector<std::string>& codes) {
  std::string text = "%YAML:1.0\n---\nnmarkers: " + count + "\nmarkersize: " + side + "\n";
  for (std::size_t i = 0; i < codes.size(); ++i) {
    text += "marker_" + std::to_string(i) + ": \"" + codes[i] + "\"\n";
  }
  return text;
}

std::string error_of(const std::string& text) {
  try {
    find_dictionary(file_with(text));
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "no error";
}

TEST(MarkerDictionary, AFileGivesItsPatterns) {
  const auto dictionary =
      find_dictionary(file_with(text_with("2", "4", {"1000000000000001", "0100000000000000"})));
  EXPECT_EQ(dictionary->markerSize, 4);
  ASSERT_EQ(dictionary->bytesList.rows, 2);
  const cv::Mat bits =
      cv::aruco::Dictionary::getBitsFromByteList(dictionary->bytesList.rowRange(0, 1), 4);
  EXPECT_EQ(cv::countNonZero(bits), 2);
  EXPECT_EQ(bits.at<unsigned char>(0, 0), 1);
  EXPECT_EQ(bits.at<unsigned char>(3, 3), 1);
}

// OpenCV writes one cell for each character, wherever that is.
TEST(MarkerDictionary, CodesOfAnotherLengthAreRefused) {
  const std::string good(16, '1');
  EXPECT_EQ(error_of(text_with("1", "4", {good})), "no error");
  for (const std::size_t length : {0, 15, 17, 4000}) {
    EXPECT_THAT(error_of(text_with("2", "4", {good, std::string(length, '1')})),
                HasSubstr("marker_1 is no text of 16 digits"))
        << length;
  }
  EXPECT_THAT(error_of(text_with("2", "4", {good})), HasSubstr("marker_1 is no text"));
  EXPECT_THAT(error_of("%YAML:1.0\n---\nnmarkers: 1\nmarkersize: 4\nmarker_0: 1\n"),
              HasSubstr("marker_0 is no text"));
}

TEST(MarkerDictionary, SizesAndCountsHaveBounds) {
  for (const char* side : {"0", "-4", "11", "46341", "4.5", "wide"}) {
    EXPECT_THAT(error_of(text_with("1", side, {"1"})), HasSubstr("markersize is no whole number"))
        << side;
  }
  for (const char* count : {"0", "-1", "1025", "2000000000", "x"}) {
    EXPECT_THAT(error_of(text_with(count, "1", {"1"})), HasSubstr("nmarkers is no whole number"))
        << count;
  }
  EXPECT_THAT(error_of("nonsense"), HasSubstr("is not an OpenCV file"));
  EXPECT_THAT(error_of("%YAML:1.0\n---\n- 1\n"), HasSubstr("is not an OpenCV file"));
  EXPECT_THROW(find_dictionary("no/such.yml"), std::runtime_error);
}

// Of a server or a scene.
TEST(MarkerDictionary, OthersMayNotNameFiles) {
  const std::string file = file_with(text_with("1", "1", {"1"}));
  EXPECT_EQ(find_dictionary(file)->markerSize, 1);
  EXPECT_THROW(predefined_dictionary(file), std::runtime_error);
  EXPECT_THROW(predefined_dictionary(""), std::runtime_error);
  EXPECT_EQ(predefined_dictionary("DICT_6X6_250"), "DICT_6X6_250");
}

}  // namespace
}  // namespace amalgam::tracking
