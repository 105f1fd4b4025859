// What the runs of a setting say together: the rows of summary.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/run_row.h"
#include "report/statistics.h"

namespace amalgam::report {

// A point below so many floors may be as good as the reference: its error is not known.
constexpr double kFloors = 3.0;

// Settings are compared by their least times: whatever else a machine does only adds to them.
struct PointSummary {
  std::string scene, sweep, point, reference;
  std::string settings;  // all that the picture before JPEG depends on; equal ones render alike
  double value = RunRow::kNone;
  std::uint64_t jpeg_quality = 0;  // 0: patched
  std::size_t runs = 0;
  double time_min = 0.0, time_median = 0.0, time_p5 = 0.0, time_p95 = 0.0;  // milliseconds
  // Means over the places that the camera looks from, each counted once: runs from the same place
  // have the same picture.
  double mae = 0.0;
  Interval mae_interval;  // 95 %, bootstrap over places; equal to the mean with one place
  double mse = 0.0, mrse = 0.0, ssim = 0.0, psnr = 0.0, jpeg_mae = 0.0;
  double maximum = 0.0;         // the largest
  std::uint64_t nonfinite = 0;  // the most of a run
  double limit_mae = RunRow::kNone, floor_mae = RunRow::kNone;
  double efficiency = 0.0;  // 1 / (MSE t), t the least time in seconds
  bool at_floor = false;
  // Among the points of the scene that are compared with the same reference. A setting that several
  // sweeps have takes part once, where it comes first, with the least time of all: their times
  // differ by chance. Qualities of JPEG take no part: they change nothing before JPEG.
  bool pareto = false;
  std::string equal_time, equal_error;  // "sweep point" of the partner; empty: none is better
  std::optional<double> slope;          // of the sweep's law, see laws.h
};

std::string full_name(const PointSummary& point);  // "samples 4"

// In the order in which points first appear.
std::vector<PointSummary> summarise(const std::vector<RunRow>& rows);

// summary.csv.
std::string summary_csv(const std::vector<PointSummary>& points);

// The different values of a member, in the order of their first points.
std::vector<std::string> names_of(const std::vector<PointSummary>& points,
                                  std::string PointSummary::*member);

}  // namespace amalgam::report
