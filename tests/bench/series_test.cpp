#include "bench/series.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace amalgam::bench {
namespace {

TEST(Series, MedianOfOddAndEvenNumbers) {
  EXPECT_DOUBLE_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_DOUBLE_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_THROW(median({}), std::invalid_argument);
}

TEST(Series, TheRatioIsTheMedianOfTheRounds) {
  // The second round was slow on both sides, which does not matter.
  const Ratio ratio = ratio_of_rounds({10.0, 30.0, 11.0}, {5.0, 15.0, 5.0});
  EXPECT_DOUBLE_EQ(ratio.value, 2.0);
  EXPECT_DOUBLE_EQ(ratio.low, 2.0);
  EXPECT_DOUBLE_EQ(ratio.high, 2.2);
  EXPECT_DOUBLE_EQ(ratio.above, 11.0);
  EXPECT_DOUBLE_EQ(ratio.below, 5.0);
  EXPECT_EQ(ratio.rounds, 3);
  EXPECT_THROW(ratio_of_rounds({1.0}, {}), std::invalid_argument);
  EXPECT_THROW(ratio_of_rounds({}, {}), std::invalid_argument);
}

TEST(Series, MeasuresByTurns) {
  std::string order;
  const auto side = [&order](char name, double value) {
    return [&order, name, value] {
      order += name;
      return value;
    };
  };
  const Ratio ratio =
      measure_by_turns({.least = 3, .most = 3, .seconds = 60.0}, side('a', 6.0), side('b', 2.0));
  EXPECT_EQ(order, "ababab");
  EXPECT_DOUBLE_EQ(ratio.value, 3.0);
}

TEST(Series, EndsWhenTheTimeIsUp) {
  const auto one = [] { return 1.0; };
  EXPECT_EQ(measure_by_turns({.least = 2, .most = 9, .seconds = 0.0}, one, one).rounds, 2);
}

}  // namespace
}  // namespace amalgam::bench
