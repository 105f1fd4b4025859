#include "support/heat_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace amalgam::test_support {
namespace {

// The grid's lines without their frame.
std::vector<std::string> grid(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  |")) rows.push_back(line.substr(3, line.size() - 4));
  }
  return rows;
}

TEST(HeatMap, ACharacterForEachStepOfTheTolerance) {
  common::Image<double> differences(9, 1);
  const double values[] = {
      0.0, 0.01, 0.1, 1.0, 2.0, 5.0, 20.0, 21.0, std::numeric_limits<double>::infinity()};
  for (int x = 0; x < 9; ++x) differences.at(x, 0) = 0.5 * values[x];
  const std::string text = heat_map(differences, 0.5);
  EXPECT_EQ(grid(text), std::vector<std::string>{" .:-+*#@!"});
  EXPECT_NE(text.find("'.' to 0.005"), std::string::npos) << text;
  EXPECT_NE(text.find("'#' to 10 "), std::string::npos) << text;
  EXPECT_NE(text.find("largest difference inf at (8, 0); 5 of 9 pixels over the tolerance of 0.5"),
            std::string::npos)
      << text;
}

TEST(HeatMap, WithoutAToleranceTheLargestIsTheScale) {
  common::Image<double> differences(4, 1);
  for (int x = 0; x < 4; ++x) differences.at(x, 0) = x == 0 ? 0.0 : std::pow(10.0, x);
  const std::string text = heat_map(differences, 0.0);  // 10, 100, 1000: a step is 100
  EXPECT_EQ(grid(text), std::vector<std::string>{" :-#"});
  EXPECT_NE(text.find("3 of 4 pixels over"), std::string::npos) << text;
  EXPECT_EQ(grid(heat_map(common::Image<double>(2, 1), 0.0)), std::vector<std::string>{"  "});
}

TEST(HeatMap, ACellShowsItsWorstPixel) {
  common::Image<double> differences(128, 96);  // cells of 2 x 4
  differences.at(0, 0) = 0.1;
  differences.at(1, 3) = 1.5;   // the same cell
  differences.at(127, 95) = 9;  // the last cell
  const std::string text = heat_map(differences, 1.0);
  const std::vector<std::string> rows = grid(text);
  ASSERT_EQ(rows.size(), 24u);
  std::string first(64, ' '), last(64, ' ');
  first.front() = '+';
  last.back() = '#';
  EXPECT_EQ(rows.front(), first);
  EXPECT_EQ(rows.back(), last);
  EXPECT_NE(text.find("a character is 2 x 4 pixels"), std::string::npos) << text;
  EXPECT_NE(text.find("largest difference 9 at (127, 95); 2 of"), std::string::npos) << text;
}

TEST(HeatMap, FitsATerminalAndHasEveryPixel) {
  for (const auto& [width, height] :
       {std::pair(1, 1), {65, 1}, {1, 49}, {640, 480}, {1280, 1024}, {100, 2000}}) {
    for (const auto& [x, y] : {std::pair(0, 0), {width - 1, height - 1}}) {
      common::Image<double> differences(width, height);
      differences.at(x, y) = 9.0;
      const std::vector<std::string> rows = grid(heat_map(differences, 1.0));
      EXPECT_LE(rows.size(), static_cast<std::size_t>(kHeatMapHeight));
      std::ptrdiff_t marked = 0;
      for (const std::string& row : rows) {
        EXPECT_LE(row.size(), static_cast<std::size_t>(kHeatMapWidth));
        marked += std::count(row.begin(), row.end(), '#');
      }
      EXPECT_EQ(marked, 1) << width << "x" << height;
    }
  }
}

}  // namespace
}  // namespace amalgam::test_support
