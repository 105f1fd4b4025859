// Everything that report.html shows.
#pragma once

#include <string>
#include <vector>

#include "bench/thesis_result.h"
#include "common/image.h"
#include "report/bound_check.h"
#include "report/determinism.h"
#include "report/jitter.h"
#include "report/laws.h"
#include "report/run_row.h"
#include "report/summary.h"
#include "report/truth_part.h"

namespace amalgam::report {

struct WorstCase {
  std::string scene, point;
  double mae = 0.0;
  common::ImageRgb32f ours, reference;  // display-linear
};

struct ReportData {
  std::string command;  // that made it
  RunRow host;          // commit, processor, threads, size: what all rows share
  std::vector<PointSummary> points;
  std::vector<Law> laws;
  std::vector<BoundCheck> bounds;
  std::vector<JitterErrors> jitter;
  std::vector<LayersHash> hashes;
  std::vector<bench::ThesisResult> table;
  std::vector<TruthRow> truth;
  std::vector<WorstCase> worst;
  std::vector<std::string> notes;  // what is missing, and why
};

}  // namespace amalgam::report
