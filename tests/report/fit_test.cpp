#include "report/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace amalgam::report {
namespace {

TEST(Fit, LeastSquaresOfThreePoints) {
  // By hand: mean (1, 2), sum of dx dy = 3, of dx^2 = 2.
  const auto fit = fit_line(std::vector{0.0, 1.0, 2.0}, std::vector{1.0, 1.0, 4.0});
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->slope, 1.5);
  EXPECT_DOUBLE_EQ(fit->intercept, 0.5);
}

TEST(Fit, PowerLaw) {
  std::vector<double> x, y;
  for (const double n : {1.0, 4.0, 9.0, 16.0}) {
    x.push_back(n);
    y.push_back(0.02 * std::pow(n, -0.75));
  }
  // What a logarithm does not have.
  x.insert(x.end(), {0.0, 25.0, 36.0});
  y.insert(y.end(), {1.0, 0.0, std::nan("")});
  const auto fit = fit_power(x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -0.75, 1e-12);
  EXPECT_NEAR(std::exp(fit->intercept), 0.02, 1e-12);
}

// Mirrors that reflect r: the error after D bounces is r^(D+1) / (1 - r).
TEST(Fit, GeometricSeries) {
  std::vector<double> x, y;
  for (const double depth : {1.0, 2.0, 5.0, 10.0}) {
    x.push_back(depth);
    y.push_back(std::pow(0.9, depth + 1.0) / 0.1);
  }
  const auto fit = fit_exponential(x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, std::log(0.9), 1e-12);
  EXPECT_NEAR(std::exp(fit->intercept), 9.0, 1e-9);
}

TEST(Fit, OnePlaceHasNoSlope) {
  EXPECT_FALSE(fit_line(std::vector<double>{}, std::vector<double>{}));
  EXPECT_FALSE(fit_line(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}));
  EXPECT_THROW(fit_line(std::vector{2.0}, std::vector{1.0, 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::report
