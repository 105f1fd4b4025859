// amalgam-report's command line.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/scene_meter.h"

namespace amalgam::report {

struct ReportOptions {
  bool quick = false;
  std::string output;               // folder
  std::string references;           // folder
  std::string scenes;               // folder
  std::vector<std::string> only;    // scenes; empty: all
  std::vector<std::string> sweeps;  // empty: all
  std::vector<std::string> parts;   // of kReportParts; empty: all
  glm::ivec2 size{0};
  RunPlan plan;
  int threads = 0;  // 0: one for each core

  bool wants(const std::string& part) const;
};

// Besides the sweeps.
inline constexpr const char* kJitterPart = "jitter";
inline constexpr const char* kDeterminismPart = "determinism";
inline constexpr const char* kTablePart = "table-6.1";
inline constexpr const char* kTruthPart = "truth";
inline constexpr const char* kSweepPart = "sweeps";

// Nothing if the program is to end (--help). Throws std::invalid_argument with one line.
std::optional<ReportOptions> parse_report_options(int argc, char** argv);

}  // namespace amalgam::report
