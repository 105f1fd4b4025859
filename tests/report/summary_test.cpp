#include "report/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "report/laws.h"

namespace amalgam::report {
namespace {

RunRow row(const std::string& point, std::uint64_t run, std::uint64_t place, double time,
           double error) {
  RunRow result;
  result.scene = "complex";
  result.sweep = "samples";
  result.point = point;
  result.value = std::stod(point);
  result.samples = std::stoull(point);
  result.reference = "best";
  result.run = run;
  result.offset = place;
  result.time_ms = time;
  result.mae = error;
  result.mse = error * error;
  result.floor_mae = 0.01;
  return result;
}

// Three runs from one place and one from another: the error's mean counts places.
TEST(Summary, PlacesCountOnce) {
  const auto points = summarise({row("1", 0, 0, 10.0, 0.2), row("1", 1, 0, 12.0, 0.2),
                                 row("1", 2, 0, 14.0, 0.2), row("1", 3, 1, 16.0, 0.4)});
  ASSERT_EQ(points.size(), 1u);
  const PointSummary& point = points[0];
  EXPECT_EQ(point.runs, 4u);
  EXPECT_DOUBLE_EQ(point.mae, 0.3);
  EXPECT_DOUBLE_EQ(point.mae_interval.low, 0.2);
  EXPECT_DOUBLE_EQ(point.mae_interval.high, 0.4);
  EXPECT_DOUBLE_EQ(point.time_min, 10.0);
  EXPECT_DOUBLE_EQ(point.time_median, 13.0);
  EXPECT_DOUBLE_EQ(point.time_p5, 10.3);
  EXPECT_DOUBLE_EQ(point.time_p95, 15.7);
  EXPECT_DOUBLE_EQ(point.mse, 0.1);
  EXPECT_NEAR(point.efficiency, 1.0 / (0.1 * 0.010), 1e-9);
  EXPECT_FALSE(point.at_floor);
}

TEST(Summary, ThreeFloorsAreTheLimit) {
  const auto points = summarise({row("1", 0, 0, 10.0, 0.0301), row("4", 0, 0, 20.0, 0.0299)});
  EXPECT_FALSE(points[0].at_floor);
  EXPECT_TRUE(points[1].at_floor);
}

TEST(Summary, OnlyEqualReferencesCompare) {
  RunRow other = row("9", 0, 0, 5.0, 0.1);
  other.reference = "another";
  RunRow elsewhere = row("1", 0, 0, 1.0, 0.01);
  elsewhere.scene = "glass bunny";
  const auto points =
      summarise({row("1", 0, 0, 10.0, 0.2), row("4", 0, 0, 20.0, 0.3), other, elsewhere});
  EXPECT_TRUE(points[0].pareto);
  EXPECT_FALSE(points[1].pareto);
  EXPECT_EQ(points[1].equal_time, "samples 1");
  EXPECT_EQ(points[1].equal_error, "samples 1");
  EXPECT_TRUE(points[2].pareto);
  EXPECT_TRUE(points[3].pareto);
}

// The default is in many sweeps. Its times there differ by chance: the least of them counts.
TEST(Summary, ASettingTakesPartOnce) {
  RunRow again = row("1", 0, 0, 7.0, 0.2);
  again.sweep = "adaptive";
  RunRow worse = row("1", 0, 0, 8.0, 0.3);
  worse.sweep = "depth";
  worse.max_depth = 3;
  const auto points = summarise({row("1", 0, 0, 10.0, 0.2), again, worse});
  EXPECT_TRUE(points[0].pareto);
  EXPECT_EQ(points[0].equal_error, "");
  EXPECT_FALSE(points[1].pareto);
  EXPECT_FALSE(points[2].pareto);
  EXPECT_EQ(points[2].equal_time, "samples 1");
}

TEST(Summary, QualitiesOfJpegTakeNoPart) {
  RunRow quality = row("1", 0, 0, 5.0, 0.2);
  quality.sweep = "JPEG quality";
  quality.jpeg_quality = 50;
  const auto points = summarise({row("1", 0, 0, 10.0, 0.2), row("4", 0, 0, 8.0, 0.3), quality});
  EXPECT_TRUE(points[0].pareto);
  EXPECT_TRUE(points[1].pareto);
  EXPECT_FALSE(points[2].pareto);
}

TEST(Summary, TheFileHasAColumnForEachName) {
  const CsvText text = parse_csv(summary_csv(summarise({row("1", 0, 0, 10.0, 0.2)})));
  ASSERT_EQ(text.rows.size(), 2u);
  EXPECT_EQ(text.rows[0].size(), text.rows[1].size());
}

PointSummary measured(const std::string& sweep, double value, double error) {
  PointSummary point;
  point.scene = "corridor";
  point.sweep = sweep;
  point.point = std::to_string(value);
  point.value = value;
  point.limit_mae = error;
  return point;
}

std::vector<PointSummary> power(const std::string& sweep, double slope) {
  std::vector<PointSummary> points;
  for (const double x : {1.0, 4.0, 16.0}) points.push_back(measured(sweep, x, std::pow(x, slope)));
  return points;
}

bool passes(const std::vector<PointSummary>& points) {
  const auto laws = find_laws(points, {{"corridor", 0.9}});
  return laws.size() == 1 && laws[0].pass;
}

TEST(Laws, SlopesPassWithinTenPercent) {
  EXPECT_TRUE(passes(power("samples", -0.5)));
  EXPECT_TRUE(passes(power("samples", -0.46)));
  EXPECT_FALSE(passes(power("samples", -0.44)));
  EXPECT_TRUE(passes(power("samples", -0.82)));
  EXPECT_FALSE(passes(power("samples", -0.83)));
  EXPECT_TRUE(passes(power("cut-off", 1.09)));
  EXPECT_FALSE(passes(power("cut-off", 1.11)));
  EXPECT_FALSE(passes(power("cut-off", 0.89)));
  EXPECT_TRUE(passes(power("lights", -0.3)));
  EXPECT_FALSE(passes(power("lights", 0.1)));
}

TEST(Laws, DepthFallsAsTheMirrorsReflect) {
  const auto corridor = [](double reflectance) {
    std::vector<PointSummary> points;
    for (const double depth : {1.0, 4.0, 9.0}) {
      points.push_back(measured("depth", depth, std::pow(reflectance, depth)));
    }
    return points;
  };
  EXPECT_TRUE(passes(corridor(0.9)));
  EXPECT_FALSE(passes(corridor(0.88)));
  EXPECT_FALSE(passes(corridor(0.92)));
  EXPECT_TRUE(find_laws(corridor(0.9), {}).empty());
}

// Below what renderers differ by anyway, a point would only bend the line.
TEST(Laws, PointsWithoutAnEffectAreLeftOut) {
  auto points = power("samples", -0.5);
  points.push_back(measured("samples", 64.0, 0.9 * kNoEffect));
  EXPECT_TRUE(passes(points));
  points.push_back(measured("samples", 64.0, 1.1 * kNoEffect));
  EXPECT_FALSE(passes(points));
}

TEST(Laws, NeedThreePoints) {
  auto points = power("samples", -0.5);
  points.pop_back();
  EXPECT_TRUE(find_laws(points, {}).empty());
  points.push_back(measured("samples", 9.0, std::nan("")));
  EXPECT_TRUE(find_laws(points, {}).empty());
}

TEST(Laws, SlopesAreWrittenToTheirPoints) {
  auto points = power("samples", -0.5);
  points.push_back(measured("fresnel", 1.0, 0.1));
  set_slopes(points, find_laws(points, {}));
  ASSERT_TRUE(points[0].slope);
  EXPECT_NEAR(*points[0].slope, -0.5, 1e-12);
  EXPECT_FALSE(points.back().slope);
}

}  // namespace
}  // namespace amalgam::report
