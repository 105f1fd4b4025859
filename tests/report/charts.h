// The charts of the report, one idea each.
#pragma once

#include <string>
#include <vector>

#include "report/chart.h"
#include "report/laws.h"
#include "report/summary.h"

namespace amalgam::report {

// What is measured in a scene.
Chart scene_chart(const std::vector<PointSummary>& points, const std::string& scene);

// What one knob does: error against time, a series for each scene. The knob "JPEG quality" changes
// nothing before JPEG: its error is that of JPEG, over the time that it takes.
Chart sweep_chart(const std::vector<PointSummary>& points, const std::string& sweep);

// A law: the error to the knob's limit against the knob, a series and its fitted line for each
// scene.
Chart law_chart(const std::vector<PointSummary>& points, const std::vector<Law>& laws,
                const std::string& sweep);

}  // namespace amalgam::report
