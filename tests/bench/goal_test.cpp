#include "bench/goal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bench/goals/goal_list.h"

namespace amalgam::bench {
namespace {

GoalLine line(Comparison comparison, double bound, Outcome outcome) {
  return {{"name", "this / that", comparison, bound, ""}, std::move(outcome)};
}

TEST(Goal, ComparesInTheDirectionOfTheGoal) {
  EXPECT_TRUE(holds(1.8, Comparison::AtLeast, 1.8));
  EXPECT_FALSE(holds(1.79, Comparison::AtLeast, 1.8));
  EXPECT_TRUE(holds(1.25, Comparison::AtMost, 1.25));
  EXPECT_FALSE(holds(1.26, Comparison::AtMost, 1.25));
  EXPECT_TRUE(holds(199.0, Comparison::Below, 200.0));
  EXPECT_FALSE(holds(200.0, Comparison::Below, 200.0));
}

TEST(Goal, NotANumberMeetsNothing) {
  const double nan = std::nan("");
  EXPECT_FALSE(holds(nan, Comparison::AtLeast, 0.0));
  EXPECT_FALSE(holds(nan, Comparison::AtMost, 0.0));
  EXPECT_FALSE(holds(nan, Comparison::Below, 0.0));
}

TEST(Goal, IsMetByItsRatio) {
  EXPECT_EQ(verdict(line(Comparison::AtMost, 1.0, Measurement{0.5, 0.4, 0.6, ""})), Verdict::Met);
  EXPECT_EQ(verdict(line(Comparison::AtMost, 1.0, Measurement{1.5, 0.4, 1.6, ""})),
            Verdict::NotMet);
}

TEST(Goal, IsNotMetWhereAConditionBesideTheRatioIsBroken) {
  Measurement fast_but_wrong{0.5, 0.4, 0.6, ""};
  fast_but_wrong.broken_condition = "bytes changed";
  EXPECT_EQ(verdict(line(Comparison::AtMost, 1.0, fast_but_wrong)), Verdict::NotMet);
}

TEST(Goal, IsNeitherWhereNothingWasMeasured) {
  EXPECT_EQ(verdict(line(Comparison::AtMost, 1.0, NotMeasured{"no scene"})), Verdict::NotMeasured);
}

TEST(Goal, WhatGoesWrongIsNoFigure) {
  GoalBench bench("/there/is/no/such/folder", 2);
  const MeasuredGoal broken{{"broken", "", Comparison::AtMost, 1.0, ""},
                            [](GoalBench&) -> Outcome { throw std::runtime_error("no GPU"); }};
  const GoalLine result = measure(broken, bench);
  ASSERT_EQ(verdict(result), Verdict::NotMeasured);
  EXPECT_TRUE(std::get<NotMeasured>(result.outcome).failed);
  EXPECT_EQ(std::get<NotMeasured>(result.outcome).reason, "failed: no GPU");
}

TEST(Goal, AMissingSceneIsNotMeasured) {
  GoalBench bench("/there/is/no/such/folder", 2);
  for (const MeasuredGoal& goal : all_goals()) {
    if (goal.goal.name != "hybrid" && goal.goal.name != "thesis-rows") continue;
    const GoalLine result = measure(goal, bench);
    ASSERT_EQ(verdict(result), Verdict::NotMeasured) << goal.goal.name;
    EXPECT_FALSE(std::get<NotMeasured>(result.outcome).failed);
    EXPECT_NE(std::get<NotMeasured>(result.outcome).reason.find("fetch_assets.sh"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace amalgam::bench
