#include "report/summary.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "report/pareto.h"

namespace amalgam::report {
namespace {

using Rows = std::vector<const RunRow*>;

std::vector<double> values(const Rows& rows, double RunRow::*member) {
  std::vector<double> result;
  for (const RunRow* row : rows) result.push_back(row->*member);
  return result;
}

// The first row of each place.
Rows one_of_each_place(const Rows& rows) {
  std::map<std::uint64_t, const RunRow*> places;
  for (const RunRow* row : rows) places.emplace(row->offset, row);
  Rows result;
  for (const auto& [place, row] : places) result.push_back(row);
  return result;
}

// The mean of the numbers among them; NaN if there are none.
double mean_of_known(std::vector<double> numbers) {
  std::erase_if(numbers, [](double number) { return std::isnan(number); });
  return numbers.empty() ? RunRow::kNone : mean(numbers);
}

std::string settings_of(const RunRow& row) {
  return csv_line({row.renderer, std::to_string(row.samples), csv_number(row.adaptive_threshold),
                   std::to_string(row.max_depth), csv_number(row.importance_cutoff), row.fresnel,
                   row.env_lights, row.shadow_edges, csv_number(row.render_scale)});
}

PointSummary summarise_point(const Rows& rows) {
  const RunRow& first = *rows.front();
  PointSummary point;
  point.scene = first.scene;
  point.sweep = first.sweep;
  point.point = first.point;
  point.reference = first.reference;
  point.settings = settings_of(first);
  point.jpeg_quality = first.jpeg_quality;
  point.value = first.value;
  point.runs = rows.size();
  const std::vector<double> times = values(rows, &RunRow::time_ms);
  point.time_min = percentile(times, 0.0);
  point.time_median = percentile(times, 0.5);
  point.time_p5 = percentile(times, 0.05);
  point.time_p95 = percentile(times, 0.95);

  const Rows places = one_of_each_place(rows);
  const std::vector<double> errors = values(places, &RunRow::mae);
  point.mae = mean(errors);
  point.mae_interval = bootstrap_mean(errors);
  point.mse = mean(values(places, &RunRow::mse));
  point.mrse = mean(values(places, &RunRow::mrse));
  point.ssim = mean(values(places, &RunRow::ssim));
  point.psnr = mean(values(places, &RunRow::psnr));
  point.jpeg_mae = mean(values(places, &RunRow::jpeg_mae));
  point.limit_mae = mean_of_known(values(places, &RunRow::limit_mae));
  point.floor_mae = mean_of_known(values(places, &RunRow::floor_mae));
  for (const RunRow* row : rows) {
    point.maximum = std::max(point.maximum, row->maximum);
    point.nonfinite = std::max(point.nonfinite, row->nonfinite);
  }
  point.efficiency = 1.0 / (point.mse * point.time_min / 1000.0);
  point.at_floor = point.mae < kFloors * point.floor_mae;
  return point;
}

// Points that may be compared, all different.
struct Group {
  std::vector<PointSummary*> points;
  std::vector<Cost> costs;

  void add(PointSummary& point) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i]->settings != point.settings) continue;
      costs[i].time = std::min(costs[i].time, point.time_min);
      return;
    }
    points.push_back(&point);
    costs.push_back({point.time_min, point.mae});
  }
};

void compare(const Group& group) {
  const std::vector<PointSummary*>& points = group.points;
  const std::vector<Cost>& costs = group.costs;
  const std::vector<bool> flags = pareto_flags(costs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i]->pareto = flags[i];
    if (const auto partner = equal_time_partner(costs, i)) {
      points[i]->equal_time = full_name(*points[*partner]);
    }
    if (const auto partner = equal_error_partner(costs, i)) {
      points[i]->equal_error = full_name(*points[*partner]);
    }
  }
}

}  // namespace

std::string full_name(const PointSummary& point) {
  return point.sweep + " " + point.point;
}

std::vector<PointSummary> summarise(const std::vector<RunRow>& rows) {
  std::vector<std::string> order;
  std::map<std::string, Rows> by_point;
  for (const RunRow& row : rows) {
    const std::string key = csv_line({row.scene, row.sweep, row.point});
    if (!by_point.contains(key)) order.push_back(key);
    by_point[key].push_back(&row);
  }
  std::vector<PointSummary> points;
  for (const std::string& key : order) points.push_back(summarise_point(by_point[key]));
  std::map<std::string, Group> groups;
  for (PointSummary& point : points) {
    if (point.jpeg_quality == 0) groups[csv_line({point.scene, point.reference})].add(point);
  }
  for (const auto& [key, group] : groups) compare(group);
  return points;
}

std::string summary_csv(const std::vector<PointSummary>& points) {
  std::string text = csv_line({"scene",
                               "sweep",
                               "point",
                               "value",
                               "runs",
                               "time_min_ms",
                               "time_median_ms",
                               "time_p5_ms",
                               "time_p95_ms",
                               "mae",
                               "mae_low_95",
                               "mae_high_95",
                               "mse",
                               "mrse",
                               "ssim",
                               "psnr_db",
                               "maximum",
                               "nonfinite",
                               "jpeg_mae",
                               "limit_mae",
                               "floor_mae",
                               "at_floor",
                               "efficiency_per_s",
                               "slope",
                               "pareto",
                               "equal_time_partner",
                               "equal_error_partner",
                               "reference"});
  const auto number = [](double value) { return std::isnan(value) ? "" : csv_number(value); };
  const auto yes_no = [](bool value) { return std::string(value ? "yes" : "no"); };
  for (const PointSummary& p : points) {
    text += csv_line({p.scene,
                      p.sweep,
                      p.point,
                      number(p.value),
                      std::to_string(p.runs),
                      number(p.time_min),
                      number(p.time_median),
                      number(p.time_p5),
                      number(p.time_p95),
                      number(p.mae),
                      number(p.mae_interval.low),
                      number(p.mae_interval.high),
                      number(p.mse),
                      number(p.mrse),
                      number(p.ssim),
                      number(p.psnr),
                      number(p.maximum),
                      std::to_string(p.nonfinite),
                      number(p.jpeg_mae),
                      number(p.limit_mae),
                      number(p.floor_mae),
                      yes_no(p.at_floor),
                      number(p.efficiency),
                      number(p.slope.value_or(RunRow::kNone)),
                      yes_no(p.pareto),
                      p.equal_time,
                      p.equal_error,
                      p.reference});
  }
  return text;
}

std::vector<std::string> names_of(const std::vector<PointSummary>& points,
                                  std::string PointSummary::*member) {
  std::vector<std::string> names;
  for (const PointSummary& point : points) {
    if (std::find(names.begin(), names.end(), point.*member) == names.end()) {
      names.push_back(point.*member);
    }
  }
  return names;
}

}  // namespace amalgam::report
