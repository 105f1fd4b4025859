#include "report/gnuplot.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <regex>
#include <stdexcept>

#include "bench/povray/temporary_folder.h"
#include "bench/shell.h"
#include "report/csv.h"
#include "report/label_places.h"

namespace amalgam::report {
namespace {

// Pixels. The axes' box has a fixed place, so that labels can be placed in it.
constexpr glm::dvec2 kPicture{620.0, 520.0}, kBoxLow{86.0, 150.0}, kBoxHigh{596.0, 480.0};
// Visible on white and on black.
constexpr std::array kColors = {"#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1",
                                "#3aa6a0", "#c0a02c", "#9c755f", "#d37295", "#8a8a8a"};
constexpr std::array kShapes = {7, 5, 9, 11, 13, 6, 4, 8, 10, 12};

// A string of gnuplot's language, taken literally.
std::string literal(std::string_view text) {
  std::string result(1, '\'');
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

bool is_shown(const ChartPoint& point) {
  return point.x > 0.0 && point.y > 0.0;
}

std::vector<ChartPoint> shown_points(const ChartSeries& series) {
  std::vector<ChartPoint> shown;
  std::copy_if(series.points.begin(), series.points.end(), std::back_inserter(shown), is_shown);
  return shown;
}

std::string tics(const LogAxis& axis) {
  std::string text = "(";
  for (const double tick : axis.ticks) {
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.6g", tick);
    text += (text.size() > 1 ? ", " : "") + literal(shown) + " " + csv_number(tick);
  }
  return text + ")";
}

std::string axis_lines(const char* name, const LogAxis& axis, const std::string& label) {
  const std::string n(name);
  return "set " + n + "range [" + csv_number(axis.low) + ":" + csv_number(axis.high) + "]\n" +
         "set " + n + "tics " + tics(axis) + "\nset " + n + "label " + literal(label) + "\n";
}

struct Axes {
  LogAxis x, y;
};

Axes axes_of(const std::vector<ChartPoint>& points) {
  std::vector<double> x, y;
  for (const ChartPoint& point : points) {
    x.insert(x.end(), {point.x, point.x_low, point.x_high});
    y.insert(y.end(), {point.y, point.y_low, point.y_high});
  }
  return {log_axis(x), log_axis(y)};
}

std::string labels(const std::vector<ChartPoint>& points, const Axes& axes) {
  const glm::dvec2 size = kBoxHigh - kBoxLow;
  std::vector<LabelledPoint> labelled;
  for (const ChartPoint& point : points) {
    labelled.push_back(
        {size * glm::dvec2(axes.x.place(point.x), axes.y.place(point.y)), point.label});
  }
  const auto places = place_labels(labelled, size);
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const glm::dvec2 at = places[i]->at / size;
    text += "set label " + literal(labelled[i].text) + " at graph " + csv_number(at.x) +
            ", graph " + csv_number(at.y) + " left front font ',11'\n";
  }
  return text;
}

std::string data_block(const std::string& name, const std::vector<ChartPoint>& points) {
  std::string text = name + " << END\n";
  for (const ChartPoint& p : points) {
    // A logarithmic axis has no place for 0.
    const auto low = [](double low, double value) { return low > 0.0 ? low : value; };
    for (const double value :
         {p.x, p.y, low(p.x_low, p.x), p.x_high, low(p.y_low, p.y), p.y_high}) {
      text += csv_number(value) + " ";
    }
    text += '\n';
  }
  return text + "END\n";
}

std::string plots(const std::string& block, const ChartSeries& series, std::size_t index) {
  const int number = series.color.value_or(static_cast<int>(index));
  const bool in_text_color = number == ChartSeries::kTextColor;
  const std::size_t look = in_text_color ? 0 : static_cast<std::size_t>(number);
  const std::string color = literal(in_text_color ? "black" : kColors[look % kColors.size()]);
  const std::string shape = std::to_string(kShapes[look % kShapes.size()]);
  const bool has_line = series.style != ChartSeries::Style::Points;
  std::string text;
  if (has_line) text += block + " using 1:2 with lines lw 1.5 lc rgb " + color;
  if (series.style != ChartSeries::Style::Line) {
    if (has_line) text += " notitle, ";
    text += block + " using 1:2:3:4:5:6 with xyerrorbars ps 0.7 pt " + shape + " lc rgb " + color;
  }
  return text + (series.name.empty() ? " notitle" : " title " + literal(series.name));
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

void check_gnuplot() {
  if (bench::output_of("command -v gnuplot").empty()) {
    throw std::runtime_error("gnuplot is not there: apt-get install gnuplot-nox");
  }
}

std::string gnuplot_program(const Chart& chart) {
  std::vector<ChartPoint> all;
  for (const ChartSeries& series : chart.series) {
    const auto shown = shown_points(series);
    all.insert(all.end(), shown.begin(), shown.end());
  }
  if (all.empty()) return {};
  const Axes axes = axes_of(all);
  char place[256];
  std::snprintf(place, sizeof place,
                "set lmargin at screen %.6f\nset rmargin at screen %.6f\n"
                "set bmargin at screen %.6f\nset tmargin at screen %.6f\n",
                kBoxLow.x / kPicture.x, kBoxHigh.x / kPicture.x, kBoxLow.y / kPicture.y,
                kBoxHigh.y / kPicture.y);
  char terminal[128];
  std::snprintf(terminal, sizeof terminal,
                "set terminal svg size %.0f,%.0f dynamic noenhanced font 'sans-serif,13'\n",
                kPicture.x, kPicture.y);
  std::string program = terminal;
  program += place;
  program +=
      "set logscale xy\nset key at screen 0.5, screen 0.01 center bottom horizontal maxcols 3 "
      "Left reverse samplen 1.5 width 1\n";
  program +=
      "set bars small\nset tics nomirror\nset border 3\nset title " + literal(chart.title) + "\n";
  program += axis_lines("x", axes.x, chart.x_label) + axis_lines("y", axes.y, chart.y_label);
  program += labels(all, axes);
  std::string plot;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const auto points = shown_points(chart.series[i]);
    if (points.empty()) continue;
    std::string block("$series");
    block += std::to_string(i);
    program += data_block(block, points);
    plot += (plot.empty() ? "plot " : ", \\\n") + plots(block, chart.series[i], i);
  }
  return program + plot + "\n";
}

std::string draw(const Chart& chart, const std::string& id_prefix) {
  const std::string program = gnuplot_program(chart);
  if (program.empty()) return {};
  const bench::TemporaryFolder folder;
  const auto path = folder.path() / "chart.gnuplot";
  std::ofstream(path) << program;
  std::string text = bench::output_of("gnuplot " + bench::quoted(path) + " 2>&1");
  const std::size_t begin = text.find("<svg");
  const std::size_t end = text.rfind("</svg>");
  if (begin == std::string::npos || end == std::string::npos) {
    throw std::runtime_error("gnuplot: " + text.substr(0, text.find('\n')));
  }
  text = text.substr(begin, end - begin) + "</svg>\n";
  for (const char* quote : {"'", "\""}) {
    const std::string q(quote);
    replace_all(text, q + "black" + q, q + "currentColor" + q);
    replace_all(text, "id=" + q, "id=" + q + id_prefix);
  }
  replace_all(text, "'rgb(  0,   0,   0)'", "'currentColor'");
  replace_all(text, "href='#", "href='#" + id_prefix);
  // Browsers would show titles as tool tips.
  return std::regex_replace(text, std::regex("<title>[^<]*</title>"), "");
}

}  // namespace amalgam::report
