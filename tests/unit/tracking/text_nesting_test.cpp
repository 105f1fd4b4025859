// Files that are nested so deeply that a parser which calls itself for each level would crash.
#include "tracking/text_nesting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "client/tracking/board_description.h"
#include "client/tracking/calibration.h"
#include "client/tracking/poses_file.h"

namespace amalgam::tracking {
namespace {

using testing::HasSubstr;

std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::filesystem::path file_with(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file =
      std::filesystem::path(testing::TempDir()) / ("nesting_" + std::string(test->name()));
  std::ofstream(file) << text;
  return file;
}

template <typename Work>
std::string error_of(const Work& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

// Each crashes OpenCV 4.6 at once, with a stack of 8 MiB.
std::vector<std::string> deep_texts() {
  const std::string yaml = "%YAML:1.0\n---\n", xml = "<?xml version=\"1.0\"?><opencv_storage>";
  constexpr std::size_t kLevels = 100'000;
  return {
      yaml + "markers: " + times(kLevels, "["),
      yaml + "markers: " + times(kLevels, "{a: "),
      yaml + "markers:\n  " + times(kLevels, "- ") + "1\n",
      yaml + times(kLevels, "a: ") + "1\n",
      yaml + times(kLevels, "a:") + "1\n",
      // What looks like an end and is none.
      yaml + "markers: " + times(kLevels, "[\"]\","),
      yaml + "markers: " + times(kLevels, "[']',"),
      yaml + "markers: " + times(kLevels, "[a\",\"]\","),
      yaml + "markers: " + times(kLevels, "[ #]\n  "),
      "{\"markers\": " + times(kLevels, "[/*]*/"),
      "{\"markers\": " + times(kLevels, "[//]\n"),
      xml + times(kLevels, "<a>"),
      xml + times(kLevels / 2, "<a><!--</a>-->"),
  };
}

TEST(TextNesting, DeepTextsAreRefused) {
  for (const std::string& text : deep_texts()) {
    EXPECT_TRUE(may_nest_too_deeply(text)) << text.substr(0, 60);
  }
}

TEST(TextNesting, BoardsAndCalibrationsSaySo) {
  for (const std::string& text : deep_texts()) {
    if (text.size() > 1 << 20) continue;  // refused for its size
    const auto file = file_with(text);
    EXPECT_THAT(error_of([&] { client::load_board(file); }), HasSubstr("is nested too deeply"));
    EXPECT_THAT(error_of([&] { client::load_calibration(file); }),
                HasSubstr("is nested too deeply"));
  }
}

// Long is not deep: lists of corners, the largest board in one line, a comment on each line.
TEST(TextNesting, LongTextsAreNotRefused) {
  EXPECT_FALSE(may_nest_too_deeply(""));
  EXPECT_FALSE(may_nest_too_deeply("{\"points\": [" + times(60'000, "[1.5, -2e-3],") + "[0, 0]]}"));
  const std::string marker =
      R"({"id": 40, "position": [0, 0, 0], "rotation": [0, 0, 0, 1], "length": 0.04},)";
  EXPECT_FALSE(may_nest_too_deeply("{\"markers\": [" + times(1000, marker) + "]}"));
  EXPECT_FALSE(
      may_nest_too_deeply("<?xml version=\"1.0\"?>" + times(4000, "<_><id>1</id><length/></_>\n")));
  EXPECT_FALSE(may_nest_too_deeply("%YAML:1.0\n---\n" +
                                   times(20'000, "a: [1, 2]  # it's a line: - it's long\n")));
  EXPECT_FALSE(may_nest_too_deeply("%YAML:1.0\n---\n" +
                                   times(20'000, "  - { id: 40, position: [0, 0, 0] }\n")));
}

// The JSON library parses them without calling itself, but copies them so.
TEST(PosesFile, MayBeNestedDeeply) {
  constexpr std::size_t kLevels = 400'000;
  const std::string deep = times(kLevels, "[") + times(kLevels, "]");
  const auto file = file_with("{\"poses\": [{\"marker\": 1, \"rotation\": " + deep + "}]}");
  EXPECT_THAT(error_of([&] { client::load_poses(file); }),
              HasSubstr("'rotation' is not 4 numbers"));
  EXPECT_THAT(error_of([&] { client::load_poses(file_with("{\"poses\": " + deep + "}")); }),
              HasSubstr("poses[0] has no 'rotation'"));
}

}  // namespace
}  // namespace amalgam::tracking
