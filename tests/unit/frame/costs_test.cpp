#include "frame/costs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace amalgam::frame {
namespace {

TEST(RelativeCosts, WhatWasMeasuredIsBelieved) {
  RelativeCosts costs({1.0, 0.8, 0.6, 0.4, 0.2});
  costs.learn(1, 3, 0.3);
  EXPECT_NEAR(costs.ratio(3, 1), 0.3, 1e-12);
  EXPECT_NEAR(costs.ratio(1, 0), 0.8, 1e-12) << "nothing was learned about what is above";
  EXPECT_NEAR(costs.ratio(4, 3), 0.5, 1e-12) << "nor about what is below";
  EXPECT_NEAR(costs.ratio(2, 1), 0.75 * std::sqrt(0.6), 1e-12) << "the way is shared";
  costs.learn(3, 1, 4.0);
  EXPECT_NEAR(costs.ratio(1, 3), 4.0, 1e-12);
}

TEST(RelativeCosts, LessQualityNeverCostsMore) {
  RelativeCosts costs({1.0, 0.9, 0.8, 0.7, 0.6});
  costs.learn(1, 3, 1.5);
  for (std::size_t level = 1; level < 5; ++level) EXPECT_LE(costs.ratio(level, level - 1), 1.0);
  costs.learn(4, 2, 0.5);
  for (std::size_t level = 1; level < 5; ++level) EXPECT_LE(costs.ratio(level, level - 1), 1.0);
}

TEST(RelativeCosts, NonsenseIsNotLearned) {
  RelativeCosts costs({1.0, 0.5});
  costs.learn(0, 0, 3.0);
  costs.learn(0, 1, 0.0);
  costs.learn(0, 1, -1.0);
  costs.learn(0, 1, std::numeric_limits<double>::quiet_NaN());
  costs.learn(0, 1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(costs.ratio(1, 0), 0.5);
  costs.learn(0, 1, 1e-9);  // something else has changed too
  EXPECT_NEAR(costs.ratio(1, 0), 0.125, 1e-12);
}

}  // namespace
}  // namespace amalgam::frame
