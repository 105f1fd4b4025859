#include "report/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace amalgam::report {
namespace {

TEST(Statistics, PercentilesLieOnAStraightLine) {
  std::vector<double> values(21);
  std::iota(values.rbegin(), values.rend(), 10.0);  // 30, 29, ..., 10
  EXPECT_DOUBLE_EQ(percentile(values, 0.0), 10.0);
  EXPECT_DOUBLE_EQ(percentile(values, 0.05), 11.0);
  EXPECT_DOUBLE_EQ(percentile(values, 0.5), 20.0);
  EXPECT_DOUBLE_EQ(percentile(values, 0.975), 29.5);
  EXPECT_DOUBLE_EQ(percentile(values, 1.0), 30.0);
  EXPECT_DOUBLE_EQ(percentile({7.0}, 0.95), 7.0);
  EXPECT_DOUBLE_EQ(percentile({1.0, 2.0}, 0.5), 1.5);
}

TEST(Statistics, NothingHasNone) {
  EXPECT_THROW(mean({}), std::invalid_argument);
  EXPECT_THROW(percentile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(bootstrap_mean({}), std::invalid_argument);
}

// The means of samples of n values of variance v have the variance v / n, and for many values they
// are normal: the interval is 1.96 sqrt(v / n) on each side. For 0, 1, ..., n - 1, v is
// (n^2 - 1) / 12.
TEST(Statistics, BootstrapIntervalOfEvenlySpreadValues) {
  constexpr int kCount = 200;
  std::vector<double> values(kCount);
  std::iota(values.begin(), values.end(), 0.0);
  const double centre = 0.5 * (kCount - 1);
  const double half = 1.96 * std::sqrt((kCount * kCount - 1) / 12.0 / kCount);
  const Interval interval = bootstrap_mean(values);
  // 2000 samples: an end of the interval is known to about 4 % of its half width.
  EXPECT_NEAR(interval.low, centre - half, 0.12 * half);
  EXPECT_NEAR(interval.high, centre + half, 0.12 * half);
}

TEST(Statistics, BootstrapHasASeed) {
  const std::vector<double> values{3.0, 1.0, 4.0, 1.0, 5.0};
  const Interval a = bootstrap_mean(values, 7), b = bootstrap_mean(values, 7);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  EXPECT_LT(a.low, mean(values));
  EXPECT_GT(a.high, mean(values));
}

TEST(Statistics, EqualValuesAreSure) {
  const Interval interval = bootstrap_mean(std::vector<double>{0.25, 0.25, 0.25});
  EXPECT_EQ(interval.low, 0.25);
  EXPECT_EQ(interval.high, 0.25);
}

}  // namespace
}  // namespace amalgam::report
