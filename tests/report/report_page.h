// report.html.
#pragma once

#include <string>

#include "report/report_data.h"

namespace amalgam::report {

// The whole file. Throws std::runtime_error if gnuplot fails.
std::string report_page(const ReportData& data);

}  // namespace amalgam::report
