// The parts of report.html below its charts.
#pragma once

#include "report/html.h"
#include "report/report_data.h"

namespace amalgam::report {

// All are empty if there is nothing to show.
Html laws_section(const std::vector<Law>& laws);
Html bounds_section(const std::vector<BoundCheck>& bounds);
Html jitter_section(const std::vector<JitterErrors>& rows);
Html determinism_section(const std::vector<LayersHash>& rows);
Html thesis_section(const std::vector<bench::ThesisResult>& rows);
Html truth_section(const std::vector<TruthRow>& rows);
Html worst_section(const std::vector<WorstCase>& cases);
Html points_section(const std::vector<PointSummary>& points);

}  // namespace amalgam::report
