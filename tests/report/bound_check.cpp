#include "report/bound_check.h"

#include "bench/series.h"
#include "report/laws.h"

namespace amalgam::report {

std::vector<BoundCheck> check_bounds(const std::vector<RunRow>& rows) {
  std::vector<BoundCheck> checks;
  std::vector<std::vector<double>> ratios;  // by checks
  for (const RunRow& row : rows) {
    // Only the run at the first place is compared with the limit.
    if ((row.sweep != "depth" && row.sweep != "cut-off") || !(row.limit_mae > kNoEffect) ||
        row.run != 0) {
      continue;
    }
    if (checks.empty() || checks.back().scene != row.scene) {
      checks.push_back({.scene = row.scene});
      ratios.emplace_back();
    }
    BoundCheck& check = checks.back();
    ++check.settings;
    if (row.limit_mae <= row.truncation_bound_mean) ++check.held;
    ratios.back().push_back(row.truncation_bound_mean / row.limit_mae);
  }
  for (std::size_t i = 0; i < checks.size(); ++i) checks[i].median_ratio = bench::median(ratios[i]);
  return checks;
}

}  // namespace amalgam::report
