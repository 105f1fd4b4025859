#include "report/charts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/fit.h"

namespace amalgam::report {
namespace {

constexpr const char* kTimeAxis = "least time of a frame [ms]";
constexpr const char* kErrorAxis = "mean absolute error [display-linear, white = 1]";
constexpr const char* kJpegSweep = "JPEG quality";

// Sweeps whose errors are to another reference would not compare.
constexpr const char* kLightsSweep = "lights";

ChartPoint timed(const PointSummary& point, double error, const Interval& interval,
                 const std::string& label) {
  return {point.time_min, error,         point.time_min, point.time_median,
          interval.low,   interval.high, label};
}

ChartPoint timed(const PointSummary& point, const std::string& label) {
  return timed(point, point.mae, point.mae_interval, label);
}

std::string label_of(const PointSummary& point) {
  return point.at_floor ? point.point + " (at floor)" : point.point;
}

}  // namespace

Chart scene_chart(const std::vector<PointSummary>& points, const std::string& scene) {
  Chart chart{.title = scene + ": every setting", .x_label = kTimeAxis, .y_label = kErrorAxis};
  ChartSeries pareto{
      .name = "Pareto line", .style = ChartSeries::Style::Line, .color = ChartSeries::kTextColor};
  for (const std::string& sweep : names_of(points, &PointSummary::sweep)) {
    if (sweep == kLightsSweep || sweep == kJpegSweep) continue;
    ChartSeries series{.name = sweep};
    for (const PointSummary& point : points) {
      if (point.scene != scene || point.sweep != sweep) continue;
      series.points.push_back(timed(point, point.pareto ? full_name(point) : ""));
      if (point.pareto) pareto.points.push_back(timed(point, ""));
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  std::sort(pareto.points.begin(), pareto.points.end(),
            [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; });
  chart.series.push_back(std::move(pareto));
  return chart;
}

Chart sweep_chart(const std::vector<PointSummary>& points, const std::string& sweep) {
  const bool of_jpeg = sweep == kJpegSweep;
  Chart chart{.title = sweep + " (labels: its values)",
              .x_label = kTimeAxis,
              .y_label = of_jpeg ? "error of JPEG alone [display-linear, white = 1]" : kErrorAxis};
  if (sweep == kLightsSweep)
    chart.y_label = "error to very many lights [display-linear, white = 1]";
  for (const std::string& scene : names_of(points, &PointSummary::scene)) {
    ChartSeries series{.name = scene, .style = ChartSeries::Style::Both};
    for (const PointSummary& point : points) {
      if (point.scene != scene || point.sweep != sweep) continue;
      series.points.push_back(
          of_jpeg ? timed(point, point.jpeg_mae, {point.jpeg_mae, point.jpeg_mae}, point.point)
                  : timed(point, label_of(point)));
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart law_chart(const std::vector<PointSummary>& points, const std::vector<Law>& laws,
                const std::string& sweep) {
  Chart chart{.title = sweep + ": error to its limit",
              .x_label = sweep,
              .y_label = "mean absolute error to the limit [white = 1]"};
  for (const std::string& scene : names_of(points, &PointSummary::scene)) {
    ChartSeries series{.name = scene};
    std::vector<double> knob, error;
    for (const PointSummary& point : points) {
      if (point.scene != scene || point.sweep != sweep) continue;
      if (!(point.limit_mae > kNoEffect) || std::isnan(point.value)) continue;
      const double e = point.limit_mae;
      series.points.push_back({point.value, e, point.value, point.value, e, e, ""});
      knob.push_back(point.value);
      error.push_back(e);
    }
    if (series.points.empty()) continue;
    const bool has_law = std::any_of(laws.begin(), laws.end(), [&](const Law& law) {
      return law.scene == scene && law.sweep == sweep;
    });
    series.style = has_law ? ChartSeries::Style::Points : ChartSeries::Style::Both;
    chart.series.push_back(series);
    const auto fit = fit_power(knob, error);
    if (!has_law || !fit) continue;
    const auto [least, most] = std::minmax_element(knob.begin(), knob.end());
    char slope[48];
    std::snprintf(slope, sizeof slope, ": power %.2f", fit->slope);
    chart.series.back().name += slope;
    ChartSeries line{.style = ChartSeries::Style::Line,
                     .color = static_cast<int>(chart.series.size()) - 1};
    for (const double x : {*least, *most}) {
      const double y = std::exp(fit->intercept + fit->slope * std::log(x));
      line.points.push_back({x, y, x, x, y, y, ""});
    }
    chart.series.push_back(std::move(line));
  }
  return chart;
}

}  // namespace amalgam::report
