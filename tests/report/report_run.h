// The whole program after its command line: measures, and writes the three files.
#pragma once

#include "report/report_options.h"

namespace amalgam::report {

// Throws std::runtime_error with one line.
void make_report(const ReportOptions& options);

}  // namespace amalgam::report
