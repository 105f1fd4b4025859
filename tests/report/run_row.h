// One row of runs.csv: a run of one setting, and everything that was measured.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "report/csv.h"

namespace amalgam::report {

struct RunRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // an empty field

  // Where.
  std::string commit, host_cpu, isa;
  std::uint64_t threads = 0;
  // What.
  std::string scene;
  std::uint64_t width = 0, height = 0;  // pixels
  std::string sweep, point;
  double value = kNone;  // the point as a number
  // All knobs.
  std::string renderer;
  std::uint64_t samples = 0;
  double adaptive_threshold = kNone;
  std::uint64_t max_depth = 0;
  double importance_cutoff = 0.0;
  std::string fresnel, env_lights, shadow_edges;
  double render_scale = 1.0;
  double exposure = 1.0;           // metered once for each scene
  std::uint64_t jpeg_quality = 0;  // 0: patched
  std::string reference;           // to_string(ReferenceSpec)
  // Which run.
  std::uint64_t run = 0;
  std::uint64_t offset = 0;               // its number, see sub_pixel_offset()
  double offset_x = 0.0, offset_y = 0.0;  // pixels
  // Times, milliseconds.
  double time_ms = 0.0;   // wall clock, from the client's JPEG to the composite's
  double cpu_ms = 0.0;    // of all threads
  std::string stages_ms;  // "mask 12.1; trace 30.5"
  std::uint64_t rays_primary = 0, rays_reflection = 0, rays_refraction = 0, rays_shadow = 0,
                rays_lookup = 0;
  std::uint64_t output_bytes = 0;
  // Errors of the float composite, display-linear.
  double mae = 0.0, mse = 0.0, mrse = 0.0, ssim = 0.0, psnr = 0.0, maximum = 0.0;
  std::uint64_t nonfinite = 0;
  double limit_mae = kNone;  // to the same setting with the knob at its limit, all traced
  double floor_mae = kNone;  // of the reference
  double jpeg_mae = 0.0;     // the decoded composite to the float composite
  // The renderer's own bound of what truncated branches may have lacked.
  double truncation_bound_mean = kNone, truncation_bound_worst = kNone;
};

// The names of all columns.
CsvRow run_columns();
CsvRow to_csv(const RunRow& row);
// Throws std::invalid_argument unless the row has as many fields as there are columns.
RunRow parse_run_row(const CsvRow& fields);

// What tells rows apart: scene, sweep, point, run.
std::string run_key(const RunRow& row);

}  // namespace amalgam::report
