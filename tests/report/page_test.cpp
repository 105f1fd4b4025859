// What report.html and its charts are made of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "report/charts.h"
#include "report/gnuplot.h"
#include "report/html.h"
#include "report/label_places.h"
#include "report/progress_line.h"
#include "report/report_page.h"

namespace amalgam::report {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Html, TextIsEscaped) {
  EXPECT_EQ(text("<a href=\"x\">&'").markup, "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  EXPECT_EQ(element("p", "a < b").markup, "<p>a &lt; b</p>\n");
  EXPECT_EQ(element("p", "\"", text("x")).markup, "<p class=\"&quot;\">x</p>\n");
}

TEST(Html, PicturesAreInThePage) {
  // "Man" and the paddings, of RFC 4648.
  EXPECT_THAT(png_image("Man", "m").markup, HasSubstr("base64,TWFu\""));
  EXPECT_THAT(png_image("Ma", "m").markup, HasSubstr("base64,TWE=\""));
  EXPECT_THAT(png_image("", "\"><script>").markup, Not(HasSubstr("<script>")));
}

TEST(Html, NumbersHaveThreeDigits) {
  EXPECT_EQ(number(0.00123456).markup, "0.00123");
  EXPECT_EQ(number(std::nan("")).markup, "-");
}

TEST(LogAxis, HoldsItsValues) {
  const LogAxis axis = log_axis({2.0, 300.0, 0.0, -1.0, std::nan("")});
  EXPECT_GT(axis.place(2.0), 0.02);
  EXPECT_LT(axis.place(300.0), 0.98);
  EXPECT_EQ(axis.place(axis.low), 0.0);
  EXPECT_DOUBLE_EQ(axis.place(axis.high), 1.0);
  EXPECT_NEAR(axis.place(std::sqrt(axis.low * axis.high)), 0.5, 1e-12);
  EXPECT_THAT(axis.ticks, Each(Gt(axis.low)));
  EXPECT_THAT(log_axis({2.0, 50.0}).ticks, ElementsAre(2.0, 5.0, 10.0, 20.0, 50.0));
}

// However alike the values: an axis without numbers says nothing.
TEST(LogAxis, HasNumbers) {
  for (double value = 1.0; value < 10.0; value *= 1.03) {
    EXPECT_GE(log_axis({value}).ticks.size(), 2u) << value;
    EXPECT_GE(log_axis({value, 1.7 * value}).ticks.size(), 2u) << value;
    EXPECT_GE(log_axis({value, 1e4 * value}).ticks.size(), 4u) << value;
    EXPECT_LE(log_axis({value, 1e4 * value}).ticks.size(), 6u) << value;
  }
}

TEST(Labels, DoNotOverlap) {
  // A crowd in the middle, with texts of 60 pixels.
  std::vector<LabelledPoint> points;
  for (int i = 0; i < 30; ++i) {
    points.push_back({{200.0 + 9.0 * (i % 6), 150.0 + 9.0 * (i / 6)}, "0123456789"});
  }
  const auto places = place_labels(points, {400.0, 300.0});
  int placed = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    ++placed;
    for (std::size_t j = 0; j < i; ++j) {
      if (!places[j]) continue;
      const glm::dvec2 apart = glm::abs(places[i]->at - places[j]->at);
      EXPECT_TRUE(apart.x > 60.0 || apart.y > 11.0) << i << " and " << j;
    }
  }
  EXPECT_GE(placed, 4);
}

TEST(Labels, StayInside) {
  const auto corners = place_labels({{{0.0, 0.0}, "aaaa"}, {{100.0, 50.0}, "aaaa"}}, {100.0, 50.0});
  ASSERT_TRUE(corners[0]);
  ASSERT_TRUE(corners[1]);
  EXPECT_GE(corners[0]->at.x, 0.0);
  EXPECT_GE(corners[0]->at.y, 5.0);
  EXPECT_LE(corners[1]->at.x, 80.0);
}

Chart small_chart() {
  return {.title = "it's <one>",
          .x_label = "time [ms]",
          .y_label = "error",
          .series = {{.name = "a & b",
                      .points = {{10.0, 0.1, 9.0, 12.0, 0.0, 0.2, "first"},
                                 {20.0, 0.0, 20.0, 20.0, 0.0, 0.0, "has no logarithm"}}}}};
}

// Quotes end a string of gnuplot's; a backquote would run a command in double quotes.
TEST(Gnuplot, TextsAreLiteral) {
  Chart chart = small_chart();
  chart.series[0].points[0].label = "a'b\n`c`";
  const std::string program = gnuplot_program(chart);
  EXPECT_THAT(program, HasSubstr("set title 'it''s <one>'"));
  EXPECT_THAT(program, HasSubstr("'a''b `c`'"));
  EXPECT_THAT(program, Not(HasSubstr("\"")));
}

TEST(Gnuplot, WhatHasNoLogarithmIsLeftOut) {
  EXPECT_THAT(gnuplot_program(small_chart()), Not(HasSubstr("has no logarithm")));
  EXPECT_THAT(gnuplot_program(small_chart()), HasSubstr("10 0.1 9 12 0.1 0.2 "));
  EXPECT_THAT(gnuplot_program({.title = "t", .x_label = "x", .y_label = "y"}), IsEmpty());
}

TEST(Gnuplot, DrawsOnePictureWithIdsOfItsOwn) {
  try {
    check_gnuplot();
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  const std::string svg = draw(small_chart(), "c7-");
  EXPECT_THAT(svg, testing::StartsWith("<svg"));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_THAT(svg, HasSubstr("it's &lt;one>"));
  EXPECT_THAT(svg, HasSubstr("first"));
  EXPECT_THAT(svg, HasSubstr("id='c7-gpPt6'"));
  EXPECT_THAT(svg, HasSubstr("href='#c7-gpPt6'"));
  EXPECT_THAT(svg, Not(HasSubstr("'black'")));
  EXPECT_THAT(svg, Not(HasSubstr("gnuplot_plot_1<")));  // a tool tip
  EXPECT_THAT(svg, Not(HasSubstr("='gpPt")));
  EXPECT_THAT(svg, Not(HasSubstr("#gpPt")));
}

PointSummary point(const std::string& name, double time, double error, bool pareto) {
  PointSummary result;
  result.scene = "a <scene>";
  result.sweep = "samples";
  result.point = name;
  result.reference = "16x16";
  result.value = std::stod(name);
  result.time_min = result.time_median = time;
  result.mae = result.mae_interval.low = result.mae_interval.high = error;
  result.limit_mae = 2.0 * error;
  result.pareto = pareto;
  return result;
}

TEST(Charts, TheParetoLineJoinsItsPointsInOrderOfTime) {
  const Chart chart = scene_chart(
      {point("16", 30, 1, true), point("4", 20, 9, false), point("1", 10, 2, true)}, "a <scene>");
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_THAT(chart.series[0].points, testing::SizeIs(3));
  EXPECT_EQ(chart.series[0].points[0].label, "samples 16");
  EXPECT_EQ(chart.series[0].points[1].label, "");
  const auto& line = chart.series[1].points;
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[0].x, 10.0);
  EXPECT_EQ(line[1].x, 30.0);
}

TEST(Charts, FittedLinesGoThroughAPowerLaw) {
  const std::vector<PointSummary> points{point("1", 1, 0.16, true), point("4", 2, 0.08, true),
                                         point("16", 3, 0.04, true)};
  const Chart chart = law_chart(points, find_laws(points, {}), "samples");
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].name, "a <scene>: power -0.50");
  EXPECT_EQ(chart.series[1].color, 0);
  EXPECT_NEAR(chart.series[1].points[0].y, 0.32, 1e-12);
  EXPECT_NEAR(chart.series[1].points[1].y, 0.08, 1e-12);
}

TEST(Page, IsOneFileWithoutNetwork) {
  ReportData data;
  data.host.commit = "<commit>";
  data.notes = {"a <note>"};
  data.truth = {{"eq. 4.5, <8> lights", 36.0, 11.5, 39.3, 10.9}};
  data.worst = {{"a <scene>", "samples 1", 0.1, common::ImageRgb32f(4, 4, glm::vec3(0.5f)),
                 common::ImageRgb32f(4, 4, glm::vec3(0.4f))}};
  data.jitter = {{.scene = "a <scene>", .draws = 5}};
  data.hashes = {{"a <scene>", "1 thread", "0123", 0, 0.0}, {"a <scene>", "avx2", "4567", 3, 0.25}};
  const std::string page = report_page(data);
  EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("a &lt;scene&gt;"));
  EXPECT_THAT(page, HasSubstr("&lt;commit&gt;"));
  EXPECT_THAT(page, HasSubstr("3 pixels by up to 0.25"));
  EXPECT_THAT(page, Not(HasSubstr("<scene>")));
  EXPECT_THAT(page, Not(HasSubstr("<note>")));
  for (const char* outside : {"src=\"http", "href=\"", "@import", "url("}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
}

TEST(Progress, TimeLeftIsInProportion) {
  using std::chrono::seconds;
  EXPECT_EQ(progress_text(0, 8, seconds(5)), "0 of 8");
  EXPECT_EQ(progress_text(2, 8, seconds(10)), "2 of 8, about 30 s left");
  EXPECT_EQ(progress_text(1, 11, seconds(60)), "1 of 11, about 10 min left");
  EXPECT_EQ(progress_text(1, 11, seconds(3600)), "1 of 11, about 10 h left");
  EXPECT_EQ(progress_text(8, 8, seconds(5)), "8 of 8, about 0 s left");
}

}  // namespace
}  // namespace amalgam::report
