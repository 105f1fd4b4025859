#include "report/bound_check.h"

#include <gtest/gtest.h>

namespace amalgam::report {
namespace {

RunRow row(const std::string& scene, const std::string& sweep, double error, double bound) {
  RunRow row;
  row.scene = scene;
  row.sweep = sweep;
  row.limit_mae = error;
  row.truncation_bound_mean = bound;
  return row;
}

TEST(BoundCheck, CountsWhereTheBoundHolds) {
  RunRow later = row("complex", "depth", 0.5, 0.1);
  later.run = 1;
  const auto checks = check_bounds(
      {row("complex", "samples", 0.1, 0.0), row("complex", "depth", 0.01, 0.02),
       row("complex", "depth", 0.01, 0.01), row("complex", "cut-off", 0.01, 0.009),
       row("complex", "cut-off", 1e-7, 0.0), later, row("mirror", "depth", RunRow::kNone, 0.5),
       row("corridor", "depth", 0.1, 0.7)});
  ASSERT_EQ(checks.size(), 2u);
  EXPECT_EQ(checks[0].scene, "complex");
  EXPECT_EQ(checks[0].settings, 3);
  EXPECT_EQ(checks[0].held, 2);
  EXPECT_NEAR(checks[0].median_ratio, 1.0, 1e-12);
  EXPECT_EQ(checks[1].held, 1);
  EXPECT_NEAR(checks[1].median_ratio, 7.0, 1e-12);
}

}  // namespace
}  // namespace amalgam::report
