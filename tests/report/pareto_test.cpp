#include "report/pareto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace amalgam::report {
namespace {

using testing::ElementsAre;

TEST(Pareto, WhatIsBeatenInBothIsOut) {
  const std::vector<Cost> points{{10, 4}, {20, 2}, {20, 3}, {30, 2}, {40, 1}, {50, 5}};
  EXPECT_THAT(pareto_flags(points), ElementsAre(true, true, false, false, true, false));
}

TEST(Pareto, EqualPointsDoNotBeatEachOther) {
  EXPECT_THAT(pareto_flags(std::vector<Cost>{{1, 1}, {1, 1}}), ElementsAre(true, true));
}

TEST(Pareto, WhatWasNotMeasuredTakesNoPart) {
  const std::vector<Cost> points{{1, std::nan("")}, {2, 1}};
  EXPECT_THAT(pareto_flags(points), ElementsAre(false, true));
  EXPECT_EQ(equal_time_partner(points, 1), std::nullopt);
}

TEST(Pareto, Partners) {
  const std::vector<Cost> points{{10, 4}, {20, 2}, {25, 3}, {40, 1}};
  // Of the third: the second is better in less time, and faster with less error.
  EXPECT_EQ(equal_time_partner(points, 2), 1u);
  EXPECT_EQ(equal_error_partner(points, 2), 1u);
  for (const std::size_t best : {0u, 1u, 3u}) {
    EXPECT_EQ(equal_time_partner(points, best), std::nullopt) << best;
    EXPECT_EQ(equal_error_partner(points, best), std::nullopt) << best;
  }
}

// The partners differ: of all at most as slow the best, of all at most as far off the fastest.
TEST(Pareto, PartnersOfTwoKinds) {
  const std::vector<Cost> points{{10, 4}, {20, 2}, {30, 5}};
  EXPECT_EQ(equal_time_partner(points, 2), 1u);
  EXPECT_EQ(equal_error_partner(points, 2), 0u);
}

}  // namespace
}  // namespace amalgam::report
