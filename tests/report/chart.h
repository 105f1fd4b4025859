// A chart as data: what gnuplot draws, and nothing about how.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace amalgam::report {

struct ChartPoint {
  double x = 0.0, y = 0.0;
  double x_low = 0.0, x_high = 0.0, y_low = 0.0, y_high = 0.0;  // interval, around x and y
  std::string label{};                                          // empty: none
};

struct ChartSeries {
  enum class Style {
    Points,  // with intervals
    Line,    // joins the points in their order
    Both,
  };
  std::string name{};  // in the legend; empty: not there
  std::vector<ChartPoint> points{};
  Style style = Style::Points;
  static constexpr int kTextColor = -1;
  std::optional<int> color{};  // kTextColor, or a series' number; nothing: one of its own
};

// Both axes are logarithmic.
struct Chart {
  std::string title;
  std::string x_label, y_label;  // with units
  std::vector<ChartSeries> series{};
};

// An axis's ends, both positive, and the numbers that are written along it: more of them for each
// power of ten if the axis is short.
struct LogAxis {
  double low = 1.0, high = 10.0;
  std::vector<double> ticks{};

  // 0 at low, 1 at high.
  double place(double value) const;
};

// Holds all positive values, with room around them. Values must have one.
LogAxis log_axis(const std::vector<double>& values);

}  // namespace amalgam::report
